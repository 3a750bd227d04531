// A quantity of the cars over time or along the road, with a cursor.

import { element, themeColours } from "../base/elements.js";
import { formatNumber } from "../base/format.js";
import { listenToPointers } from "../base/pointers.js";
import { axisLabel, digitsOf, niceStep } from "./axis.js";
import { rangeOf } from "./range.js";

const CHART = { left: 44, right: 10, top: 10, bottom: 20 }; // px around the plot
const UNITS = { time: "s", way: "m" }; // of what is to the right
const LABEL_WIDTH = 70; // px

export class Chart {
  // `lines` are {car, ghost: whether it is the run that is compared with}; `span`: what all charts show; `onSeek` is told a place.
  constructor({ title, unit, quantity, lines, limit = undefined, span, onSeek }) {
    this.quantity = quantity;
    this.lines = lines;
    this.limit = limit;
    this.span = span;
    this.onSeek = onSeek;
    this.axis = "time";
    this.canvas = element("canvas", { "aria-label": title, tabindex: "0" });
    this.still = document.createElement("canvas");
    this.value = element("span.value");
    this.root = element(
      "figure.chart", {}, element("figcaption", {}, element("span", {}, unit ? `${title} (${unit})` : title), this.value), this.canvas,
    );
    this.time = 0;
    listenToPointers(this.canvas, this);
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
    return CHART.left + ((place - this.span.from) / this.span.length) * this.plot.width;
  }

  placeAt(pixel) {
    return this.span.from + ((pixel.x - CHART.left) / this.plot.width) * this.span.length;
  }

  y(value) {
    const { low, high } = this.range;
    return CHART.top + ((high - value) / (high - low)) * this.plot.height;
  }

  refresh() {
    this.colours = themeColours();
    this.range = rangeOf(this);
    const context = this.begin(this.still);
    if (!context || !this.plot) return;
    context.clearRect(0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    this.drawAxes(context);
    context.save();
    this.clip(context);
    if (this.limit !== undefined) this.drawLimit(context);
    // The run itself is over the one that it is compared with.
    for (const ghost of [true, false]) {
      for (const line of this.lines.filter((each) => each.ghost === ghost)) this.drawLine(context, line);
    }
    context.restore();
    this.draw(this.time);
  }

  begin(canvas) {
    if (!canvas.width) return null;
    const context = canvas.getContext("2d");
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    return context;
  }

  clip(context) {
    context.beginPath();
    context.rect(CHART.left, CHART.top - 1, this.plot.width, this.plot.height + 2);
    context.clip();
  }

  drawAxes(context) {
    context.font = "11px system-ui, sans-serif";
    context.fillStyle = this.colours.muted;
    context.strokeStyle = this.colours.grid;
    context.lineWidth = 1;
    context.textAlign = "right";
    context.textBaseline = "middle";
    const { low, high, step: rule } = this.range;
    for (let number = Math.round(low / rule); number <= Math.round(high / rule); ++number) {
      context.strokeStyle = number === 0 && low < 0 ? this.colours.muted : this.colours.grid;
      this.drawRule(context, number * rule, axisLabel(number * rule, rule));
    }
    this.drawPlaces(context);
  }

  drawPlaces(context) {
    const { from, to, length } = this.span;
    const step = niceStep(length / Math.max(this.plot.width / LABEL_WIDTH, 1));
    context.textAlign = "center";
    context.textBaseline = "top";
    for (let number = Math.ceil(from / step); number * step <= to; ++number) {
      const text = `${axisLabel(number * step, step)} ${UNITS[this.axis]}`;
      const most = this.canvas.clientWidth - context.measureText(text).width / 2;
      context.fillText(text, Math.min(this.x(number * step), most), CHART.top + this.plot.height + 5);
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
    context.save();
    this.clip(context);
    context.fillStyle = this.colours.text;
    context.fillRect(this.x(place(own[0])) - 0.5, CHART.top, 1, this.plot.height);
    for (const each of own) this.drawDot(context, this.x(place(each)), each.state[this.quantity], this.colourOf(each.line));
    context.restore();
    const digits = Math.max(2, digitsOf(this.range.step));
    this.value.textContent = own.map(({ state }) => formatNumber(state[this.quantity], digits)).join("  ");
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

  // What pointers.js asks.
  press(pixel) {
    this.onSeek(this.placeAt(pixel));
  }

  pan(dx, _dy, pixel) {
    if (this.span.part) this.span.pan((-dx / this.plot.width) * this.span.length);
    else this.press(pixel);
  }

  zoom(factor, pixel) {
    this.span.zoom(factor, this.placeAt(pixel));
  }

  fit() {
    this.span.show(null);
  }

  // Who has not chosen the chart wants to scroll the page. A touchpad's pinch is a wheel with ctrl.
  takesWheel({ ctrlKey }) {
    return ctrlKey || document.activeElement === this.canvas;
  }
}
