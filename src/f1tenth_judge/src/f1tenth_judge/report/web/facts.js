// What is said of a run in words and tables.

const MEASURES = [
  { name: "lap time", unit: "s", digits: 3, of: (result) => result.times?.lap_time, better: "less" },
  { name: "finish", unit: "s", digits: 3, of: (result) => result.times?.finish },
  { name: "minimum clearance", unit: "m", digits: 3, of: (result) => result.minimum_clearance, better: "more" },
  { name: "contacts", unit: "", digits: 0, of: (result) => result.contacts?.length, better: "less" },
  { name: "real-time factor", unit: "", digits: 1, of: (result) => result.real_time_factor },
  { name: "wall time", unit: "s", digits: 1, of: (result) => result.times?.wall },
];

function badge(result) {
  const word = result.passed ? "passed" : "failed";
  return element(`span.badge.${result.passed ? "good" : "bad"}`, {}, word);
}

function verdictText(result) {
  const { verdict, expected } = result;
  return !expected || verdict === expected ? verdict : `${verdict}, expected ${expected}`;
}

function tiles(result) {
  const shown = MEASURES.filter(({ of }) => of(result) !== null && of(result) !== undefined);
  return element("dl.tiles", {}, ...shown.map(({ name, unit, digits, of }) =>
    element("div", {}, element("dt", {}, name), element("dd", {}, formatNumber(of(result), digits, unit)))));
}

function section(title, ...content) {
  return element("section.card", {}, element("h2", {}, title), ...content);
}

function table(columns, rows) {
  const head = element("tr", {}, ...columns.map((name) => element("th", { scope: "col" }, name)));
  const body = rows.map(({ cells, kind = "", click }) =>
    element(kind ? `tr.${kind}` : "tr", { click }, ...cells.map((cell, index) =>
      element("td", { "data-label": columns[index] }, cell))));
  return element("table", {}, element("thead", {}, head), element("tbody", {}, ...body));
}

function criteriaCard(result) {
  if (!result.criteria.length) return null;
  const rows = result.criteria.map((each) => ({
    kind: each.status.replace(" ", "-"),
    cells: [
      statusMark(each.status), element("code", {}, ...breakable(each.name)), formatValue(each.actual, each.unit),
      formatValue(each.limit, each.unit), each.reason,
    ],
  }));
  return section("Criteria", table(["", "criterion", "actual", "limit", "reason"], rows));
}

// A name that may be broken after its underscores, and is copied whole.
function breakable(name) {
  return name.split(/(?<=_)/).flatMap((part) => [part, element("wbr")]);
}

function statusMark(status) {
  const mark = { passed: "✓", failed: "✗", "not judged": "·" }[status] ?? status;
  return element(`span.mark.${status.replace(" ", "-")}`, { title: status, "aria-label": status }, mark);
}

// The run against the other one of the same scenario.
function comparisonCard(result) {
  const other = result.previous;
  if (!other) return null;
  const rows = MEASURES.map((measure) => comparisonRow(measure, result, other)).filter(Boolean);
  rows.unshift({ cells: ["verdict", other.verdict, result.verdict, ""] });
  const note = droveTheSame(result) ? "Both drove the same, bit for bit." : "The trajectories differ.";
  const columns = ["", commitName(other), commitName(result), "change"];
  return section("Compared with the run before", element("p.note", {}, note), table(columns, rows));
}

function droveTheSame({ trajectory_hash: hash, previous }) {
  return Boolean(hash) && hash === previous.trajectory_hash;
}

function comparisonRow({ name, unit, digits, of, better }, result, other) {
  const [now, before] = [of(result), of(other)];
  if (typeof now !== "number" && typeof before !== "number") return null;
  const change = changeOf(now, before, digits, unit, better);
  return { cells: [name, formatNumber(before, digits, unit), formatNumber(now, digits, unit), change] };
}

function changeOf(now, before, digits, unit, better) {
  if (typeof now !== "number" || typeof before !== "number") return "";
  const difference = Number((now - before).toFixed(digits));
  if (difference === 0) return "=";
  const improved = better && (better === "less") === difference < 0;
  const kind = better ? (improved ? ".better" : ".worse") : "";
  return element(`span.change${kind}`, {}, (difference > 0 ? "+" : "") + formatNumber(difference, digits, unit));
}

// The commit of the workspace, and those of drivers that are from other repositories.
function commitName({ versions }) {
  const commits = [versions?.commit, ...Object.values(versions?.driver_commits ?? {})].filter(Boolean);
  const short = commits.map((commit) => commit.slice(0, 8) + (commit.endsWith("-dirty") ? "*" : ""));
  return [...new Set(short)].join(" + ") || "unknown";
}

function lapsCard(result) {
  const cars = Object.entries(result.cars ?? {}).filter(([, { lap_times: laps }]) => laps?.length);
  if (!cars.length) return null;
  const rows = cars.flatMap(([car, { lap_times: laps }]) =>
    laps.map((time, index) => ({ cells: [car, String(index + 1), formatNumber(time, 3, "s")] })));
  return section("Laps", table(["car", "lap", "time"], rows));
}

function contactsCard(result, seek) {
  if (!result.contacts?.length) return null;
  const rows = result.contacts.map((each) => ({
    cells: [
      element("button.link", { click: () => seek(Math.max(each.start - 1, 0)) }, formatNumber(each.start, 3, "s")),
      each.car, each.touched.join(", "), formatNumber(each.speed, 2, "m/s"),
    ],
  }));
  return section("Contacts", table(["at", "car", "touched", "speed"], rows));
}

function culpritCard(result) {
  if (!result.culprit) return null;
  const { culprit, reason, log_lines: lines } = result.culprit;
  return section(`${culprit} ${reason}`, lines.length ? element("pre", {}, lines.join("\n")) : null);
}

// What could not be read or written.
function problemsCard({ problems, not_written: unwritten = [] }) {
  const all = [...problems, ...unwritten];
  return all.length ? section("Missing", element("ul", {}, ...all.map((text) => element("li", {}, text)))) : null;
}

// The files of the run, relative to the report.
function linksCard({ links }) {
  const rows = Object.entries(links).map(([name, href]) => ({ cells: [name, element("a", { href }, decodeURIComponent(href))] }));
  return rows.length ? section("Files", table(["", ""], rows)) : null;
}

function versionsCard(result) {
  const versions = Object.entries(result.versions ?? {}).flatMap(([name, value]) =>
    value instanceof Object ? Object.entries(value).map(([car, each]) => [`${name} of ${car}`, each]) : [[name, value]]);
  const rows = [["seed", result.seed], ["trajectory hash", result.trajectory_hash], ...versions];
  return section("Made with", table(["", ""], rows.map(([name, value]) => ({
    cells: [name, element("code", {}, formatValue(value))],
  }))));
}
