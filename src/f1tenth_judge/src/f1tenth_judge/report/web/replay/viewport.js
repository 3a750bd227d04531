// Which part of the map frame a canvas shows.

import { indexAfter } from "../data/geometry.js";

const MARGIN = 0.35; // m around what is shown
const AROUND = 0.6; // m around the way of a car

export class Viewport {
  constructor(box) {
    this.box = box;
    this.size = { width: 1, height: 1 };
    this.fit();
  }

  resize(width, height) {
    const fitted = this.fitted;
    this.size = { width, height };
    if (fitted) this.fit();
  }

  // Shows a rectangle: that of all unless told otherwise.
  fit(box = this.box) {
    const { left, right, bottom, top } = box;
    this.scale = Math.min(this.size.width / (right - left), this.size.height / (top - bottom));
    this.centre = { x: (left + right) / 2, y: (bottom + top) / 2 };
    this.fitted = box === this.box;
  }

  // Pixels per metre are multiplied by `factor`; the point under the pixel stays there.
  zoom(factor, pixel) {
    const before = this.toMap(pixel);
    this.scale = Math.min(Math.max(this.scale * factor, 2), 2000);
    const after = this.toMap(pixel);
    this.centre.x += before.x - after.x;
    this.centre.y += before.y - after.y;
    this.fitted = false;
  }

  pan(dx, dy) {
    this.centre.x -= dx / this.scale;
    this.centre.y += dy / this.scale;
    this.fitted = false;
  }

  follow(point) {
    if (this.fitted) this.scale = Math.max(this.scale * 2.5, Math.min(this.size.width, this.size.height) / 7);
    this.centre = { x: point.x, y: point.y };
    this.fitted = false;
  }

  toMap(pixel) {
    return {
      x: this.centre.x + (pixel.x - this.size.width / 2) / this.scale,
      y: this.centre.y - (pixel.y - this.size.height / 2) / this.scale,
    };
  }

  // Lets a context draw in metres, y upwards.
  apply(context, ratio) {
    const { scale, centre, size } = this;
    context.setTransform(
      ratio * scale, 0, 0, -ratio * scale,
      ratio * (size.width / 2 - scale * centre.x), ratio * (size.height / 2 + scale * centre.y),
    );
  }
}

class Box {
  constructor() {
    Object.assign(this, { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity });
  }

  take(xs, ys, margin = 0) {
    for (let index = 0; index < xs.length; ++index) {
      this.left = Math.min(this.left, xs[index] - margin);
      this.right = Math.max(this.right, xs[index] + margin);
      this.bottom = Math.min(this.bottom, ys[index] - margin);
      this.top = Math.max(this.top, ys[index] + margin);
    }
  }

  withMargin() {
    if (this.left > this.right) this.take([0], [0], 2);
    return { left: this.left - MARGIN, right: this.right + MARGIN, bottom: this.bottom - MARGIN, top: this.top + MARGIN };
  }
}

// The rectangle around walls and paths.
export function boundingBox(run) {
  const box = new Box();
  for (const line of run.walls.outlines) box.take(line.x, line.y);
  for (const { x, y, radius } of run.walls.circles) box.take([x], [y], radius);
  for (const car of run.cars) box.take(car.x, car.y, AROUND);
  return box.withMargin();
}

// The rectangle around where the cars were in a stretch of time (s).
export function boxOfStretch(run, { from, to }) {
  const box = new Box();
  for (const car of run.cars) {
    const [first, last] = [Math.max(indexAfter(car.time, from) - 1, 0), indexAfter(car.time, to) + 1];
    box.take(car.x.slice(first, last), car.y.slice(first, last), AROUND);
  }
  return box.withMargin();
}
