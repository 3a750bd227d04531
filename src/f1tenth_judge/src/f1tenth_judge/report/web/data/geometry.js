// Tables, shapes and poses.

/** @type {Record<string, number>} */
const ORIGIN = { x: 0, y: 0, yaw: 0 };

// A table's columns of equal length as one object per row.
export function rowsOf(table) {
  const names = Object.keys(table);
  return Array.from(table[names[0]], (_, index) => Object.fromEntries(names.map((name) => [name, table[name][index]])));
}

export function shapeOf({ outlines, circles }) {
  return { outlines, circles: rowsOf(circles) };
}

// How many of the ascending times are not after a time.
export function indexAfter(times, time) {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time + 1e-6) low = middle + 1;
    else high = middle;
  }
  return low;
}

// An angle between -pi and pi.
export function wrapped(angle) {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

export function transform(pose, point) {
  const [cosine, sine] = [Math.cos(pose.yaw), Math.sin(pose.yaw)];
  return { x: pose.x + cosine * point.x - sine * point.y, y: pose.y + sine * point.x + cosine * point.y };
}

// What a shape puts into the way of a beam, seen from the map if it is given in the frame of a pose.
export function obstaclesOf({ outlines, circles }, pose = ORIGIN) {
  const segments = outlines.flatMap(({ x, y }) => {
    const points = Array.from(x, (_, index) => transform(pose, { x: x[index], y: y[index] }));
    return points.map((point, index) => {
      const next = points[(index + 1) % points.length];
      return [point.x, point.y, next.x, next.y];
    });
  });
  return { segments, circles: circles.map((circle) => ({ ...transform(pose, circle), radius: circle.radius })) };
}
