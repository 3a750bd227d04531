// Where a car is seen from the middle of the road.

import { wrapped } from "../data/geometry.js";

// {offset: m to the left of the middle, angle: rad to the left of the driving direction} of a pose. `road`: closed, {x, y}.
export function besideRoad({ x, y }, pose) {
  let found = { distance: Infinity, offset: NaN, angle: NaN };
  for (let index = 0; index < x.length; ++index) {
    const next = (index + 1) % x.length;
    const [alongX, alongY] = [x[next] - x[index], y[next] - y[index]];
    const length = Math.hypot(alongX, alongY);
    if (length === 0) continue;
    const [toX, toY] = [pose.x - x[index], pose.y - y[index]];
    const part = Math.min(Math.max((toX * alongX + toY * alongY) / length ** 2, 0), 1);
    const distance = Math.hypot(toX - part * alongX, toY - part * alongY);
    if (distance >= found.distance) continue;
    const left = Math.sign(alongX * toY - alongY * toX);
    found = { distance, offset: left * distance, angle: wrapped(pose.yaw - Math.atan2(alongY, alongX)) };
  }
  return found;
}
