// A quantity over time, with a cursor that can be dragged.

import { element, themeColours } from "../base/elements.js";
import { formatNumber } from "../base/format.js";

const CHART = { left: 40, right: 10, top: 10, bottom: 20 }; // px around the plot

export class Chart {
  constructor({ title, unit, quantity, run, ghost, limit = undefined, onSeek }) {
    this.quantity = quantity;
    this.run = run;
    this.ghost = ghost;
    this.limit = limit;
    this.onSeek = onSeek;
    this.canvas = element("canvas", { "aria-label": `${title} over time` });
    this.still = document.createElement("canvas");
    this.value = element("span.value");
    this.root = element(
      "figure.chart", {}, element("figcaption", {}, element("span", {}, `${title} (${unit})`), this.value), this.canvas,
    );
    this.time = 0;
    this.measure();
    this.listen();
  }

  measure() {
    this.top = niceTop(Math.max(...this.allTracks().map((car) => largest(car[this.quantity])), this.limit ?? 0, 0.1));
  }

  // The run has become longer.
  grow() {
    this.measure();
    this.refresh();
  }

  allTracks() {
    return [...this.run.cars, ...(this.ghost?.cars ?? [])];
  }

  get end() {
    return Math.max(this.run.end, this.ghost?.end ?? 0, 0.001);
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

  x(time) {
    return CHART.left + (time / this.end) * this.plot.width;
  }

  y(value) {
    return CHART.top + (1 - value / this.top) * this.plot.height;
  }

  refresh() {
    this.colours = themeColours();
    const context = this.begin(this.still);
    if (!context) return;
    context.clearRect(0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    this.drawAxes(context);
    if (this.limit !== undefined) this.drawLimit(context);
    for (const car of this.ghost?.cars ?? []) this.drawLine(context, car, this.colours.ghost, [4, 3]);
    this.run.cars.forEach((car, index) => this.drawLine(context, car, this.colours.cars[index % 4], []));
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
    for (const part of [0, 0.5, 1]) this.drawRule(context, part * this.top);
    context.textAlign = "center";
    context.textBaseline = "top";
    const step = niceStep(this.end / Math.max(this.plot.width / 70, 1));
    for (let time = 0; time <= this.end; time += step) {
      context.fillText(`${Number(time.toFixed(2))} s`, this.x(time), CHART.top + this.plot.height + 5);
    }
  }

  drawRule(context, value) {
    const y = Math.round(this.y(value)) + 0.5;
    context.beginPath();
    context.moveTo(CHART.left, y);
    context.lineTo(CHART.left + this.plot.width, y);
    context.stroke();
    context.fillText(Number(value.toFixed(2)), CHART.left - 6, y);
  }

  drawLimit(context) {
    context.strokeStyle = this.colours.bad;
    context.setLineDash([2, 3]);
    this.drawRule(context, this.limit);
    context.setLineDash([]);
  }

  drawLine(context, car, colour, dash) {
    const values = car[this.quantity];
    context.beginPath();
    for (let index = 0; index < values.length; ++index) {
      context.lineTo(this.x(car.time[index]), this.y(Math.max(values[index], 0)));
    }
    context.strokeStyle = colour;
    context.lineWidth = 1.6;
    context.lineJoin = "round";
    context.setLineDash(dash);
    context.stroke();
    context.setLineDash([]);
  }

  draw(time) {
    this.time = time;
    const context = this.begin(this.canvas);
    if (!context) return;
    context.clearRect(0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    context.drawImage(this.still, 0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    context.fillStyle = this.colours.text;
    context.fillRect(this.x(time) - 0.5, CHART.top, 1, this.plot.height);
    const values = this.run.cars.map((car) => car.at(time)[this.quantity]);
    values.forEach((value, index) => this.drawDot(context, time, value, this.colours.cars[index % 4]));
    this.value.textContent = values.map((value) => formatNumber(value, 2)).join("  ");
  }

  drawDot(context, time, value, colour) {
    context.beginPath();
    context.arc(this.x(time), this.y(Math.max(value, 0)), 4, 0, 2 * Math.PI);
    context.fillStyle = colour;
    context.strokeStyle = this.colours.surface;
    context.lineWidth = 2;
    context.fill();
    context.stroke();
  }

  listen() {
    const seek = (event) => this.onSeek(((event.offsetX - CHART.left) / this.plot.width) * this.end);
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      seek(event);
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (this.canvas.hasPointerCapture(event.pointerId)) seek(event);
    });
  }
}

function largest(values) {
  return values.reduce((most, each) => Math.max(most, each), 0);
}

// 1, 2 or 5 times a power of ten, not below a value.
function niceStep(value) {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1e-6)));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= value * 0.999);
}

function niceTop(value) {
  const step = niceStep(value / 4);
  return Math.ceil((value * 1.02) / step) * step;
}
