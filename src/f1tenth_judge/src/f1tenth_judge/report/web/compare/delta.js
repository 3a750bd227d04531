// Two runs along the road: where time is gained and lost.

// The time (s) that a car has lost against another one since both began, at each of its own moments; NaN where
// the other one has not been. Both need `way`, the distance along the road.
export function deltaTo(car, other) {
  const reached = firstTimes(other);
  const begin = Math.max(car.way[0], other.way[0]);
  const [own, others] = [timeAt(firstTimes(car), begin), timeAt(reached, begin)];
  return Float64Array.from(car.way, (way, index) => car.time[index] - own - (timeAt(reached, way) - others));
}

// Which shade of `count` the path has at each moment: the first where time is gained fastest, the last where it is lost.
export function deltaShades(car, delta, count) {
  const window = 10; // moments, before and after
  const most = 0.25; // s/m that are the darkest shades
  return Array.from(delta, (_, index) => {
    const [from, to] = [Math.max(index - window, 0), Math.min(index + window, delta.length - 1)];
    const rate = (delta[to] - delta[from]) / Math.max(car.way[to] - car.way[from], 0.1);
    const part = Number.isFinite(rate) ? Math.min(Math.max(rate / most, -1), 1) : 0;
    return Math.round(((part + 1) / 2) * (count - 1));
  });
}

// When each distance was reached first: a car that goes back gains nothing.
function firstTimes({ way, time }) {
  const reached = { way: [], time: [] };
  for (let index = 0; index < way.length; ++index) {
    if (!reached.way.length || way[index] > reached.way.at(-1)) {
      reached.way.push(way[index]);
      reached.time.push(time[index]);
    }
  }
  return reached;
}

// The moment at which a distance was reached; NaN if it never was.
export function timeAt({ way, time }, distance) {
  let [low, high] = [0, way.length - 1];
  if (!(distance >= way[low] && distance <= way[high])) return NaN;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (way[middle] <= distance) low = middle;
    else high = middle;
  }
  const part = (distance - way[low]) / Math.max(way[high] - way[low], 1e-9);
  return time[low] + Math.min(part, 1) * (time[high] - time[low]);
}
