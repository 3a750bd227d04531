// A quantity of the cars over time or along the road, with a cursor that can be dragged.

import { element, themeColours } from "../base/elements.js";
import { formatNumber } from "../base/format.js";
import { timeAt } from "../compare/delta.js";
import { niceRange, niceStep } from "./axis.js";

const CHART = { left: 40, right: 10, top: 10, bottom: 20 }; // px around the plot
const UNITS = { time: "s", way: "m" }; // of what is to the right

export class Chart {
  // `lines` are {car, ghost: whether it is the run that is compared with}.
  constructor({ title, unit, quantity, lines, limit = undefined, onSeek }) {
    this.quantity = quantity;
    this.lines = lines;
    this.limit = limit;
    this.onSeek = onSeek;
    this.axis = "time";
    this.canvas = element("canvas", { "aria-label": title });
    this.still = document.createElement("canvas");
    this.value = element("span.value");
    this.root = element(
      "figure.chart", {}, element("figcaption", {}, element("span", {}, unit ? `${title} (${unit})` : title), this.value), this.canvas,
    );
    this.time = 0;
    this.measure();
    this.listen();
  }

  measure() {
    const box = { low: Math.min(this.limit ?? 0, 0), high: Math.max(this.limit ?? 0, 0.1) };
    this.begins = Infinity;
    this.ends = -Infinity;
    for (const { car } of this.lines) {
      for (const value of car[this.quantity]) {
        if (value < box.low) box.low = value;
        if (value > box.high) box.high = value;
      }
      for (const place of car[this.axis]) {
        if (place < this.begins) this.begins = place;
        if (place > this.ends) this.ends = place;
      }
    }
    if (this.axis === "time" || !Number.isFinite(this.begins)) this.begins = 0;
    this.ends = Math.max(this.ends, this.begins + 0.001);
    this.range = niceRange(box.low, box.high);
  }

  // The run has become longer.
  grow() {
    this.measure();
    this.refresh();
  }

  // `time` or `way`.
  setAxis(axis) {
    this.axis = axis;
    this.grow();
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    this.ratio = window.devicePixelRatio || 1;
    this.plot = { width: clientWidth - CHART.left - CHART.right, height: clientHeight - CHART.top - CHART.bottom };
    for (const canvas of [this.canvas, this.still]) {
      canvas.width = Math.round(clientWidth * this.ratio);
      canvas.height = Math.round(clientHeight * this.ratio);
    }
    this.refresh();
  }

  x(place) {
    return CHART.left + ((place - this.begins) / (this.ends - this.begins)) * this.plot.width;
  }

  y(value) {
    const { low, high } = this.range;
    return CHART.top + ((high - value) / (high - low)) * this.plot.height;
  }

  refresh() {
    this.colours = themeColours();
    const context = this.begin(this.still);
    if (!context || !this.plot) return;
    context.clearRect(0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    this.drawAxes(context);
    if (this.limit !== undefined) this.drawLimit(context);
    // The run itself is over the one that it is compared with.
    for (const ghost of [true, false]) {
      for (const line of this.lines.filter((each) => each.ghost === ghost)) this.drawLine(context, line);
    }
    this.draw(this.time);
  }

  begin(canvas) {
    if (!canvas.width) return null;
    const context = canvas.getContext("2d");
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    return context;
  }

  drawAxes(context) {
    context.font = "11px system-ui, sans-serif";
    context.fillStyle = this.colours.muted;
    context.strokeStyle = this.colours.grid;
    context.lineWidth = 1;
    context.textAlign = "right";
    context.textBaseline = "middle";
    const { low, high, step: rule } = this.range;
    for (let value = low; value <= high + 1e-9; value += rule) this.drawRule(context, value, String(Number(value.toFixed(3))));
    context.textAlign = "center";
    context.textBaseline = "top";
    const step = niceStep((this.ends - this.begins) / Math.max(this.plot.width / 70, 1));
    for (let place = Math.ceil(this.begins / step) * step; place <= this.ends; place += step) {
      context.fillText(`${Number(place.toFixed(2))} ${UNITS[this.axis]}`, this.x(place), CHART.top + this.plot.height + 5);
    }
  }

  drawRule(context, value, text) {
    const y = Math.round(this.y(value)) + 0.5;
    context.beginPath();
    context.moveTo(CHART.left, y);
    context.lineTo(CHART.left + this.plot.width, y);
    context.stroke();
    context.fillText(text, CHART.left - 6, y);
  }

  drawLimit(context) {
    context.strokeStyle = this.colours.bad;
    context.setLineDash([2, 3]);
    this.drawRule(context, this.limit, "");
    context.setLineDash([]);
  }

  drawLine(context, line) {
    const [places, values] = [line.car[this.axis], line.car[this.quantity]];
    context.beginPath();
    let isOpen = false;
    for (let index = 0; index < values.length; ++index) {
      if (Number.isFinite(values[index])) context[isOpen ? "lineTo" : "moveTo"](this.x(places[index]), this.y(values[index]));
      isOpen = Number.isFinite(values[index]);
    }
    context.strokeStyle = this.colourOf(line);
    context.lineWidth = 1.6;
    context.lineJoin = "round";
    context.setLineDash(line.ghost ? [4, 3] : []);
    context.stroke();
    context.setLineDash([]);
  }

  colourOf({ ghost, number }) {
    return ghost ? this.colours.ghost : this.colours.cars[number % 4];
  }

  draw(time) {
    this.time = time;
    const context = this.begin(this.canvas);
    if (!context || !this.plot) return;
    context.clearRect(0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    context.drawImage(this.still, 0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    const own = this.lines.filter(({ ghost }) => !ghost).map((line) => ({ line, state: line.car.at(time) }));
    const place = ({ state }) => (this.axis === "time" ? time : state.way);
    context.fillStyle = this.colours.text;
    context.fillRect(this.x(place(own[0])) - 0.5, CHART.top, 1, this.plot.height);
    for (const each of own) this.drawDot(context, this.x(place(each)), each.state[this.quantity], this.colourOf(each.line));
    this.value.textContent = own.map(({ state }) => formatNumber(state[this.quantity], 2)).join("  ");
  }

  drawDot(context, x, value, colour) {
    if (!Number.isFinite(value)) return;
    context.beginPath();
    context.arc(x, this.y(value), 4, 0, 2 * Math.PI);
    context.fillStyle = colour;
    context.strokeStyle = this.colours.surface;
    context.lineWidth = 2;
    context.fill();
    context.stroke();
  }

  listen() {
    const seek = (event) => {
      const place = this.begins + ((event.offsetX - CHART.left) / this.plot.width) * (this.ends - this.begins);
      const time = this.axis === "time" ? place : timeAt(this.lines[0].car, place);
      if (Number.isFinite(time)) this.onSeek(time);
    };
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      seek(event);
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (this.canvas.hasPointerCapture(event.pointerId)) seek(event);
    });
  }
}
