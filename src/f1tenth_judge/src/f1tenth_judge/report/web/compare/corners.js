// The corners of a road, and how a car drives through them.

import { wrapped } from "../data/geometry.js";
import { timeAt } from "./delta.js";

const STEP = 0.25; // m, between two places of the road
const SMOOTH = 6; // places to both sides over which the direction is looked at
const BEND = 0.12; // 1/m: less is a straight
const TURN = 0.35; // rad: less is no corner
const GAP = 1.0; // m of straight that do not divide a corner

// {number, from, to (m along the road), x, y (m, in the middle)}, in driving order. `road`: closed, {x, y}.
export function cornersOf(road) {
  const places = resampled(road);
  const bends = places.x.map((_, index) => curvature(places, index));
  return stretches(bends).filter(({ turn }) => Math.abs(turn) >= TURN).map(({ first, last }, index) => {
    const middle = Math.round((first + last) / 2) % places.x.length;
    return { number: index + 1, from: first * STEP, to: last * STEP, x: places.x[middle], y: places.y[middle] };
  });
}

// Speeds (m/s) of a car at the entry, at its slowest and at the exit of a corner, and when it entered (s); of the
// lap that begins `offset` (m) along the way. null where it has not driven through.
export function driveThrough(car, { from, to }, offset) {
  const [entry, exit] = [timeAt(car, from + offset), timeAt(car, to + offset)];
  if (Number.isNaN(entry) || Number.isNaN(exit)) return null;
  const inside = Array.from(car.speed).filter((_, index) => car.time[index] >= entry && car.time[index] <= exit);
  const [first, last] = [car.at(entry).speed, car.at(exit).speed];
  return { time: entry, entry: first, apex: Math.min(first, last, ...inside), exit: last };
}

// Where a distance (m) along a road of this length is, in words; "" where there are no corners.
export function whereOf(corners, length, way) {
  if (!corners.length || !Number.isFinite(way)) return "";
  const inLap = (distance) => distance - length * Math.floor(distance / length);
  const place = inLap(way);
  const next = corners.find(({ to }) => place <= to) ?? corners[0];
  if (place >= next.from && place <= next.to) return `in T${next.number}`;
  const last = corners.findLast(({ to }) => place > to) ?? corners.at(-1);
  return inLap(place - last.to) < inLap(next.from - place) ? `after T${last.number}` : `before T${next.number}`;
}

export function lengthOf(road) {
  return along(road).at(-1);
}

function along({ x, y }) {
  const at = [0];
  for (let index = 1; index <= x.length; ++index) {
    const next = index % x.length;
    at.push(at[index - 1] + Math.hypot(x[next] - x[index - 1], y[next] - y[index - 1]));
  }
  return at;
}

function resampled(road) {
  const at = along(road);
  const count = Math.max(Math.floor(at.at(-1) / STEP), 1);
  const [xs, ys] = [[...road.x, road.x[0]], [...road.y, road.y[0]]];
  const pick = (values) => Array.from({ length: count }, (_, index) => timeAt({ way: at, time: values }, index * STEP));
  return { x: pick(xs), y: pick(ys) };
}

// 1/m at a place, from the directions before and after it; positive to the left.
function curvature({ x, y }, index) {
  const at = (place) => (place + x.length) % x.length;
  const [before, here, after] = [at(index - SMOOTH), index, at(index + SMOOTH)];
  const heading = (from, to) => Math.atan2(y[to] - y[from], x[to] - x[from]);
  return wrapped(heading(here, after) - heading(before, here)) / (SMOOTH * STEP);
}

// Stretches that bend to one side, in places.
function stretches(bends) {
  const found = [];
  bends.forEach((bend, index) => {
    if (Math.abs(bend) < BEND) return;
    const last = found.at(-1);
    if (last && Math.sign(last.turn) === Math.sign(bend) && (index - last.last) * STEP <= GAP) {
      last.last = index;
      last.turn += bend * STEP;
    } else {
      found.push({ first: index, last: index, turn: bend * STEP });
    }
  });
  return found;
}
