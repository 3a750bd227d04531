// The charts of a run, one under the other.

import { element } from "../base/elements.js";
import { Chart } from "./chart.js";

const CHANNELS = [
  { title: "Time lost on the reference", unit: "s", quantity: "delta" },
  { title: "Speed", unit: "m/s", quantity: "speed" },
  { title: "Steering", unit: "rad", quantity: "steering" },
  { title: "Acceleration", unit: "m/s²", quantity: "acceleration" },
  { title: "Clearance", unit: "m", quantity: "clearance" },
  { title: "Gap to the leader", unit: "m", quantity: "gap" },
];

export class Channels {
  // `limits` (by quantity) are drawn as well; `onSeek` is told a time.
  constructor(run, ghost, limits, onSeek) {
    const hasRoad = run.cars.every((car) => car.way.length);
    this.axis = element("select", { "aria-label": "charts over", hidden: !hasRoad, change: () => this.setAxis(this.axis.value) },
      element("option", { value: "time" }, "over time"), element("option", { value: "way" }, "over distance"));
    this.charts = [...CHANNELS, ...ownChannels(run)].filter(({ quantity }) => run.cars.some((car) => car[quantity]?.some(Number.isFinite)))
      .map((channel) => new Chart({ ...channel, limit: limits[channel.quantity], lines: linesOf(run, ghost, channel.quantity), onSeek }));
    this.root = element("div.channels", {}, this.axis, ...this.charts.map(({ root }) => root));
  }

  setAxis(axis) {
    for (const chart of this.charts) chart.setAxis(axis);
  }

  each(act) {
    this.charts.forEach(act);
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
