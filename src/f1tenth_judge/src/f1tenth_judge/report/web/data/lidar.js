// A car's lidar, computed from what stands around it: the walls, the models, the other cars.

import { transform } from "./geometry.js";

const BEAMS = 121;

export class Lidar {
  constructor(car, [first, last, x, y, yaw, range]) {
    this.car = car;
    this.first = first;
    this.last = last;
    this.range = range;
    this.mount = { x, y, yaw };
  }

  // End points in the map frame, seen from a pose. Obstacles: {segments: [[x1, y1, x2, y2], ...], circles}.
  points(pose, { segments, circles }) {
    const origin = transform(pose, this.mount);
    const near = segments.filter((segment) => this.reaches(origin, segment));
    const round = circles.filter(({ x, y, radius }) => Math.hypot(x - origin.x, y - origin.y) < this.range + radius);
    const step = (this.last - this.first) / (BEAMS - 1);
    const points = Array.from({ length: BEAMS }, (_, beam) => {
      const angle = pose.yaw + this.mount.yaw + this.first + beam * step;
      const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
      const range = this.cast(origin, dx, dy, near, round);
      return { x: origin.x + range * dx, y: origin.y + range * dy, hit: range < this.range };
    });
    return { origin, points };
  }

  reaches({ x, y }, [x1, y1, x2, y2]) {
    const { range } = this;
    return Math.min(x1, x2) < x + range && Math.max(x1, x2) > x - range && Math.min(y1, y2) < y + range && Math.max(y1, y2) > y - range;
  }

  cast({ x, y }, dx, dy, segments, circles) {
    let nearest = this.range;
    for (const [x1, y1, x2, y2] of segments) {
      const [alongX, alongY, toX, toY] = [x2 - x1, y2 - y1, x1 - x, y1 - y];
      const cross = dx * alongY - dy * alongX;
      const part = (toX * dy - toY * dx) / cross;
      const range = (toX * alongY - toY * alongX) / cross;
      if (range > 0 && range < nearest && part >= 0 && part <= 1) nearest = range;
    }
    for (const circle of circles) {
      const [toX, toY] = [circle.x - x, circle.y - y];
      const along = toX * dx + toY * dy;
      const under = circle.radius ** 2 - (toX ** 2 + toY ** 2 - along ** 2);
      const range = along - Math.sqrt(Math.max(under, 0));
      if (under >= 0 && range > 0 && range < nearest) nearest = range;
    }
    return nearest;
  }
}
