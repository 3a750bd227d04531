// The charts of a run, one under the other, over the same stretch of time or road.

import { element } from "../base/elements.js";
import { formatNumber } from "../base/format.js";
import { timeAt } from "../compare/delta.js";
import { Chart } from "./chart.js";
import { Span } from "./span.js";

const CHANNELS = [
  { title: "Time lost on the reference", unit: "s", quantity: "delta" },
  { title: "Speed", unit: "m/s", quantity: "speed" },
  { title: "Steering", unit: "rad", quantity: "steering" },
  { title: "Acceleration", unit: "m/s²", quantity: "acceleration" },
  { title: "Clearance", unit: "m", quantity: "clearance" },
  { title: "Gap to the leader", unit: "m", quantity: "gap" },
];

const ZOOM_STEP = 2; // of a press of a key
const PAN_STEP = 0.25; // of what is seen

export class Channels {
  // `limits` (by quantity) are drawn as well; `onSeek` is told a time, `onSpan` which times (s) are seen: {from, to}, null for all.
  constructor(run, ghost, limits, { onSeek, onSpan }) {
    this.car = run.cars[0];
    this.onSpan = onSpan;
    this.time = 0;
    this.span = new Span(() => this.showSpan());
    const seek = (place) => onSeek(this.timeOf(place));
    this.charts = [...CHANNELS, ...ownChannels(run)].filter(({ quantity }) => run.cars.some((car) => car[quantity]?.some(Number.isFinite)))
      .map((channel) => new Chart({
        ...channel, limit: limits[channel.quantity], lines: linesOf(run, ghost, channel.quantity), span: this.span, onSeek: seek,
      }));
    this.root = element("div.channels", {}, this.makeTools(run), ...this.charts.map(({ root }) => root));
    this.setAxis("time");
  }

  makeTools(run) {
    const hasRoad = run.cars.every((car) => car.way.length);
    this.axis = element("select", { "aria-label": "charts over", hidden: !hasRoad, change: () => this.setAxis(this.axis.value) },
      element("option", { value: "time" }, "over time"), element("option", { value: "way" }, "over distance"));
    this.shown = element("output");
    this.all = element("button", { type: "button", click: () => this.span.show(null) }, "whole run");
    const button = (text, name, factor) => element("button", { type: "button", title: name, "aria-label": name, click: () => this.zoom(factor) }, text);
    return element("div.tools-of-charts", {}, this.axis, button("+", "zoom in", ZOOM_STEP), button("−", "zoom out", 1 / ZOOM_STEP), this.all, this.shown);
  }

  // As other charts of the same run are shown.
  showAs({ axis, span }) {
    this.axis.value = axis.value;
    this.setAxis(axis.value, span.part);
  }

  setAxis(axis, part = null) {
    for (const chart of this.charts) chart.axis = axis;
    this.span.part = part;
    this.grow();
  }

  // The run has become longer.
  grow() {
    const axis = this.axis.value;
    let [begins, ends] = [axis === "time" ? 0 : Infinity, 0];
    for (const { car } of this.charts.flatMap(({ lines }) => lines)) {
      for (const place of car[axis]) {
        if (place < begins) begins = place;
        if (place > ends) ends = place;
      }
    }
    this.span.setWhole(Number.isFinite(begins) ? begins : 0, ends);
    this.showSpan();
  }

  showSpan() {
    const { part, from, to } = this.span;
    this.all.hidden = !part;
    const unit = this.axis.value === "time" ? "s" : "m";
    this.shown.textContent = part ? `${formatNumber(from, 1)} to ${formatNumber(to, 1, unit)}` : "";
    this.refresh();
    this.onSpan(part && { from: this.timeOf(from), to: this.timeOf(to) });
  }

  // Around what is shown now.
  zoom(factor) {
    this.span.zoom(factor, this.placeOf(this.time));
  }

  pan(direction) {
    this.span.pan(direction * PAN_STEP * this.span.length);
  }

  placeOf(time) {
    return this.axis.value === "time" ? time : this.car.at(time).way;
  }

  // The car may not have been there: then the nearest.
  timeOf(place) {
    if (this.axis.value === "time") return place;
    const time = timeAt(this.car, place);
    return Number.isFinite(time) ? time : place > this.car.way[0] ? this.car.end : 0;
  }

  resize() {
    for (const chart of this.charts) chart.resize();
  }

  refresh() {
    for (const chart of this.charts) chart.refresh();
  }

  draw(time) {
    if (time !== this.time) this.span.follow(this.placeOf(time));
    this.time = time;
    for (const chart of this.charts) chart.draw(time);
  }
}

// The numbers that planners published.
function ownChannels({ cars }) {
  return [...new Set(cars.flatMap(({ topics }) => topics))].map((topic) => ({ title: topic, unit: "", quantity: topic }));
}

// What a chart shows of both runs: gaps and times lost are those of the run itself.
function linesOf(run, ghost, quantity) {
  const own = run.cars.map((car, number) => ({ car, number, ghost: false }));
  const others = (ghost?.cars ?? []).filter((car) => car[quantity]?.length);
  const compared = quantity === "gap" || quantity === "delta" ? [] : others;
  return [...own.filter(({ car }) => car[quantity]?.length), ...compared.map((car) => ({ car, number: 0, ghost: true }))];
}
