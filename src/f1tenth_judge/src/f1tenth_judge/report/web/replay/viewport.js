// Which part of the map frame a canvas shows.

const MARGIN = 0.35; // m around what is shown

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

  fit() {
    const { left, right, bottom, top } = this.box;
    this.scale = Math.min(this.size.width / (right - left), this.size.height / (top - bottom));
    this.centre = { x: (left + right) / 2, y: (bottom + top) / 2 };
    this.fitted = true;
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

// The rectangle around walls and paths.
export function boundingBox(run) {
  const box = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
  const take = (xs, ys, margin = 0) => {
    for (let index = 0; index < xs.length; ++index) {
      box.left = Math.min(box.left, xs[index] - margin);
      box.right = Math.max(box.right, xs[index] + margin);
      box.bottom = Math.min(box.bottom, ys[index] - margin);
      box.top = Math.max(box.top, ys[index] + margin);
    }
  };
  for (const line of run.walls.outlines) take(line.x, line.y);
  for (const { x, y, radius } of run.walls.circles) take([x], [y], radius);
  for (const car of run.cars) take(car.x, car.y, 0.6);
  if (box.left > box.right) take([0], [0], 2);
  return {
    left: box.left - MARGIN, right: box.right + MARGIN, bottom: box.bottom - MARGIN, top: box.top + MARGIN,
  };
}
