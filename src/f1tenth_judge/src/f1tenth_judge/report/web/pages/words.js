// What is said of a run in few words, wherever it is shown.

import { element } from "../base/elements.js";
import { formatNumber, formatValue } from "../base/format.js";

/** @type {{name: string, unit: string, digits: number, of: (result: any) => any, better: string}[]} */
export const MEASURES = [
  { name: "lap time", unit: "s", digits: 3, of: (result) => result.times?.lap_time, better: "less" },
  { name: "end", unit: "s", digits: 3, of: (result) => result.times?.finish, better: "" },
  { name: "minimum clearance", unit: "m", digits: 3, of: (result) => result.minimum_clearance, better: "more" },
  { name: "contacts", unit: "", digits: 0, of: (result) => result.contacts?.length, better: "less" },
  { name: "real-time factor", unit: "", digits: 1, of: (result) => result.real_time_factor, better: "" },
  { name: "wall time", unit: "s", digits: 1, of: (result) => result.times?.wall, better: "" },
];

export function badge(result) {
  const word = result.passed ? "passed" : "failed";
  return element(`span.badge.${result.passed ? "good" : "bad"}`, {}, word);
}

function failedCriteria(result) {
  return result.criteria.filter(({ status }) => status === "failed");
}

// The criteria that failed besides what the verdict says already.
export function failedBesides(result) {
  const failed = failedCriteria(result);
  const verdict = failed.find(({ name }) => name === "verdict");
  return failed.filter((each) => each !== verdict && each.reason !== verdict?.reason);
}

export function verdictText(result) {
  const { verdict, expected, passed } = result;
  if (expected && verdict !== expected) return `${verdict}, expected ${expected}`;
  const failed = failedCriteria(result).length;
  if (passed || !failed) return verdict;
  return `${verdict}, but ${failed === 1 ? "a criterion" : `${failed} criteria`} failed`;
}

// What a criterion measured, beside what it asks for.
export function comparisonText({ actual, limit, unit }) {
  return `${formatValue(actual, unit)}, limit ${formatValue(limit, unit)}`;
}

// Who drives a car; paths without their folders.
export function plannerName(planner) {
  return planner.replace(/^\S*\//, "");
}

// Each car with its colour, its name and its planner; nothing of runs that do not say.
export function who(result) {
  const cars = Object.entries(result.cars ?? {}).filter(([, { planner }]) => planner);
  return cars.map(([car, { planner, driver, description }], index) => element("span.who", { title: `${car}: ${planner} (${driver}) drives ${description}` },
    cars.length > 1 ? element(`span.dot.car-${(index % 4) + 1}`) : null,
    cars.length > 1 ? `${car} ` : null, element("b", {}, ...breakable(plannerName(planner)))));
}

// A name that may be broken after its underscores and colons, and is copied whole.
export function breakable(name) {
  return name.split(/(?<=[_:])/).flatMap((part) => [part, element("wbr")]);
}

// Who won a race, and by how much.
export function winnerText({ winner, cars }) {
  if (!winner) return "";
  const name = (car) => (cars[car].planner ? `${car} (${plannerName(cars[car].planner)})` : car);
  const ahead = winner.ahead === null ? "which did not finish" : `${formatNumber(winner.ahead, 3, "s")} later`;
  return `${name(winner.car)} won; second was ${name(winner.second)}, ${ahead}`;
}

export function droveTheSame({ trajectory_hash: hash, previous }) {
  return Boolean(hash) && hash === previous.trajectory_hash;
}

export function changeOf(now, before, digits, unit, better) {
  if (typeof now !== "number" || typeof before !== "number") return "";
  const difference = Number((now - before).toFixed(digits));
  if (difference === 0) return "=";
  const improved = better && (better === "less") === difference < 0;
  const kind = better ? (improved ? ".better" : ".worse") : "";
  return element(`span.change${kind}`, {}, (difference > 0 ? "+" : "") + formatNumber(difference, digits, unit));
}

// The commit of the workspace, and those of drivers that are from other repositories; "" if none is known.
export function commitName({ versions }) {
  const commits = [versions?.commit, ...Object.values(versions?.driver_commits ?? {})].filter(Boolean);
  const short = commits.map((commit) => commit.slice(0, 8) + (commit.endsWith("-dirty") ? "*" : ""));
  return [...new Set(short)].join(" + ");
}
