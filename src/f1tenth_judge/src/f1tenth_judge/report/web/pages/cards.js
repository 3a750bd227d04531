// The tables beside a replay.

import { element } from "../base/elements.js";
import { formatNumber, formatValue } from "../base/format.js";
import { table } from "../base/table.js";
import { driveThrough, lengthOf } from "../compare/corners.js";
import { LEAD } from "../data/events.js";
import { MEASURES, breakable, changeOf, commitName, droveTheSame } from "./words.js";

export function tiles(result) {
  const shown = MEASURES.filter(({ of }) => of(result) !== null && of(result) !== undefined);
  return element("dl.tiles", {}, ...shown.map(({ name, unit, digits, of }) =>
    element("div", {}, element("dt", {}, name), element("dd", {}, formatNumber(of(result), digits, unit)))));
}

export function section(title, ...content) {
  return element("section.card", {}, element("h2", {}, title), ...content);
}

// Those that failed first.
export function criteriaCard(result) {
  if (!result.criteria.length) return null;
  const sorted = result.criteria.toSorted((one, other) => Number(other.status === "failed") - Number(one.status === "failed"));
  const rows = sorted.map((each) => ({
    kind: each.status.replace(" ", "-"),
    cells: [
      statusMark(each.status), element("div", {}, element("code", {}, ...breakable(each.name)), element("p.why", {}, each.reason)),
      formatValue(each.actual, each.unit), formatValue(each.limit, each.unit),
    ],
  }));
  return element("section.card.criteria", {}, element("h2", {}, "Criteria"), table(["", "criterion", "actual", "limit"], rows));
}

function statusMark(status) {
  const mark = { passed: "✓", failed: "✗", "not judged": "·" }[status] ?? status;
  return element(`span.mark.${status.replace(" ", "-")}`, { role: "img", title: status, "aria-label": status }, mark);
}

// The run against the other one of the same scenario.
export function comparisonCard(result) {
  const other = result.previous;
  if (!other) return null;
  const rows = MEASURES.map((measure) => comparisonRow(measure, result, other)).filter(Boolean);
  rows.unshift({ cells: ["verdict", other.verdict, result.verdict, ""] });
  const note = droveTheSame(result) ? "Both drove the same, bit for bit." : "The trajectories differ.";
  const columns = ["", `before ${commitName(other)}`, `now ${commitName(result)}`, "change"];
  return section("Compared with the run before", element("p.note", {}, note), table(columns, rows));
}

function comparisonRow({ name, unit, digits, of, better }, result, other) {
  const [now, before] = [of(result), of(other)];
  if (typeof now !== "number" && typeof before !== "number") return null;
  const change = changeOf(now, before, digits, unit, better);
  return { cells: [name, formatNumber(before, digits, unit), formatNumber(now, digits, unit), change] };
}

// How the best lap went through the corners, beside that of the run that it is compared with.
export function cornersCard(corners, own, other, seek) {
  const rows = corners.map((corner) => cornerRow(corner, own, other, seek)).filter(Boolean);
  if (!rows.length) return null;
  const note = other ? "Speeds of the best lap, and how they differ from the reference." : "Speeds of the best lap.";
  return section("Corners", element("p.note", {}, note), table(["", "entry", "apex", "exit"], rows));
}

function cornerRow(corner, own, other, seek) {
  const now = driveThrough(own.run.cars[0], corner, bestLapOffset(own));
  const before = other && driveThrough(other.run.cars[0], corner, bestLapOffset({ ...other, road: own.run.road }));
  if (!now) return null;
  const speeds = ["entry", "apex", "exit"].map((part) => element("div", {},
    formatNumber(now[part], 2, "m/s"), " ", before ? changeOf(now[part], before[part], 2, "", "more") : null));
  const to = element("button.link", { type: "button", click: () => seek(now.time) }, `T${corner.number}`);
  return { cells: [to, ...speeds] };
}

// How far along the way (m) the best lap of a run's first car begins.
function bestLapOffset({ run, result, road = run.road }) {
  const [car] = run.cars;
  const laps = result.cars?.[car.name]?.lap_times ?? [];
  return laps.length ? laps.indexOf(Math.min(...laps)) * lengthOf(road) : 0;
}

export function lapsCard(result) {
  const cars = Object.entries(result.cars ?? {}).filter(([, { lap_times: laps }]) => laps?.length);
  if (!cars.length) return null;
  const rows = cars.flatMap(([car, { lap_times: laps }]) =>
    laps.map((time, index) => ({ cells: [car, String(index + 1), formatNumber(time, 3, "s")] })));
  return section("Laps", table(["car", "lap", "time"], rows));
}

// `where`: tells it in words, of a contact.
export function contactsCard(result, seek, where) {
  if (!result.contacts?.length) return null;
  const rows = result.contacts.map((each) => ({
    cells: [moment(each.start, seek), each.car, each.touched.join(", "), where(each), formatNumber(each.speed, 2, "m/s")],
  }));
  return section("Contacts", table(["at", "car", "touched", "where", "speed"], rows));
}

export function interventionsCard(result, seek) {
  if (!result.interventions?.length) return null;
  const rows = result.interventions.map((each) => ({ cells: [moment(each.time, seek), each.caller, each.kind, each.model] }));
  return section("Interventions", table(["at", "by", "what", "model"], rows));
}

// Leads to the time before a moment.
function moment(time, seek) {
  return element("button.link", { type: "button", click: () => seek(time - LEAD) }, formatNumber(time, 3, "s"));
}

export function culpritCard(result) {
  if (!result.culprit) return null;
  const { culprit, reason, log_lines: lines } = result.culprit;
  return section(`${culprit} ${reason}`, lines.length ? element("pre", {}, lines.join("\n")) : null);
}

// What could not be read or written.
export function problemsCard({ problems, not_written: unwritten = [] }) {
  const all = [...problems, ...unwritten];
  return all.length ? section("Missing", element("ul", {}, ...all.map((text) => element("li", {}, text)))) : null;
}

// The files of the run, relative to the report.
export function linksCard({ links }) {
  const rows = Object.entries(links).map(([name, href]) => ({ cells: [name, element("a", { href }, decodeURIComponent(href))] }));
  return rows.length ? section("Files", table(["", ""], rows)) : null;
}

export function versionsCard(result) {
  const versions = Object.entries(result.versions ?? {}).flatMap(([name, value]) =>
    value instanceof Object ? Object.entries(value).map(([car, each]) => [`${name} of ${car}`, each]) : [[name, value]]);
  const rows = [["seed", result.seed], ["trajectory hash", result.trajectory_hash], ...versions];
  return section("Made with", table(["", ""], rows.map(([name, value]) => ({
    cells: [element("span", {}, ...breakable(name)), element("code", {}, formatValue(value))],
  }))));
}
