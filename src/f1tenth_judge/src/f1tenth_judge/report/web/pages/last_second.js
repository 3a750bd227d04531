// What led to the end of a run that did not pass.

import { element } from "../base/elements.js";
import { formatNumber } from "../base/format.js";
import { table } from "../base/table.js";
import { besideRoad } from "../compare/beside.js";
import { indexAfter } from "../data/geometry.js";
import { section } from "./cards.js";
import { breakable } from "./words.js";

const BEFORE = [1, 0.5, 0.2, 0]; // s
const STILL = 0.02; // m/s
const LONG = 2; // s, for which a car has to stand before it is told
const BACK = 0.3; // m against the driving direction, within a second

// `decision`: of decisionOf; `car`: the one that it happened to.
export function lastSecondCard(decision, car, road) {
  const times = BEFORE.map((before) => decision.time - before).filter((time) => time >= 0);
  const states = times.map((time) => ({ ...car.at(time), beside: besideRoad(road, car.at(time)) }));
  const row = (name, digits, of) => ({ cells: [element("span", {}, ...breakable(name)), ...states.map((state) => formatNumber(of(state), digits))] });
  const rows = [
    row("speed (m/s)", 2, ({ speed }) => speed),
    row("steering (rad, left +)", 2, ({ steering }) => steering),
    row("clearance (m)", 2, ({ clearance }) => clearance),
    ...road.x.length ? [
      row("left of the middle (m)", 2, ({ beside }) => beside.offset),
      row("angle to the road (°)", 0, ({ beside }) => (beside.angle * 180) / Math.PI),
    ] : [],
    ...car.topics.map((topic) => row(topic.replace(`/${car.name}/`, ""), 2, (state) => state[topic])),
  ];
  const heads = times.map((time) => (time < decision.time ? formatNumber(time - decision.time, 1, "s") : formatNumber(time, 3, "s")));
  const card = section("The last second", table(["", ...heads], rows));
  card.classList.add("last-second");
  return card;
}

// What the reason of a verdict does not say: when and where it was, and what is striking; `where`: in words.
export function besidesReason(reason, { time }, car, where) {
  const when = /\b(at|after) [\d.]+ s\b/.test(reason) ? "" : `at ${formatNumber(time, 3, "s")}`;
  return [when, where, striking(time, car)].filter(Boolean).map((text) => `, ${text}`).join("");
}

function striking(time, car) {
  let since = indexAfter(car.time, time) - 1;
  while (since > 0 && Math.abs(car.speed[since]) < STILL) --since;
  if (time - car.time[since] > LONG) return `standing still since ${formatNumber(car.time[since], 1, "s")}`;
  return car.at(Math.max(time - 1, 0)).way - car.at(time).way > BACK ? "driving against the direction of the road" : "";
}
