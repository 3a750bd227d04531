// The page of all runs.

import { element } from "../base/elements.js";
import { NOTHING, formatDate, formatNumber } from "../base/format.js";
import { sortableTable } from "../base/table.js";
import { pathPicture } from "./thumbnail.js";
import { MEASURES, badge, changeOf, commitName, comparisonText, droveTheSame, failedBesides, verdictText, who } from "./words.js";

const [ALL, FAILED] = ["all runs", "not as expected"];
const THUMBNAIL = { width: 72, height: 44, margin: 4 }; // px

export class Overview {
  constructor(report) {
    this.report = report;
    this.root = element("div.overview", {}, this.header(), this.tools(), this.table());
    this.filter();
  }

  header() {
    const { runs, created } = this.report;
    const passed = runs.filter((run) => run.passed).length;
    const commits = [...new Set(runs.map(commitName).filter(Boolean))].join(", ");
    const wall = runs.reduce((sum, run) => sum + (run.times?.wall ?? 0), 0);
    const known = [formatDate(created), commits && `commit ${commits}`, wall && `${formatNumber(wall, 0, "s")} of wall time`];
    return element("header.head", {},
      element("h1", {}, headline(passed, runs.length)),
      element("p.lead", {}, known.filter(Boolean).join(" · ")),
      element("div.bar", { role: "img", "aria-label": `${passed} of ${runs.length} passed` },
        ...runs.map((run) => element(`a.${run.passed ? "good" : "bad"}`, {
          href: `#${encodeURIComponent(run.scenario)}`, title: `${run.scenario}: ${verdictText(run)}`,
        }))));
  }

  tools() {
    this.search = element("input.search", {
      type: "search", placeholder: "Filter by name, planner, world, reason", "aria-label": "filter by text", input: () => this.filter(),
    });
    this.kind = element("select", { "aria-label": "filter by verdict", change: () => this.filter() },
      ...this.kinds().map(([value, count]) => element("option", { value }, `${value} (${count})`)));
    return element("div.tools", {}, this.kind, this.search);
  }

  // What a run may be filtered by, and how many are of that kind.
  kinds() {
    const { runs } = this.report;
    const failed = runs.filter((run) => !run.passed).length;
    const verdicts = [...new Set(runs.map((run) => run.verdict))].sort();
    return [[ALL, runs.length], [FAILED, failed], ...verdicts.map((verdict) => [verdict, runs.filter((run) => run.verdict === verdict).length])];
  }

  table() {
    const columns = ["", "run", "planner", "verdict", "lap time", "clearance", "real time", "change"];
    const shown = sortableTable(columns, this.report.runs.map((run) => this.row(run)));
    this.rows = this.report.runs.map((run, index) => ({ run, row: shown.tBodies[0].rows[index] }));
    this.none = element("p.note", { hidden: true }, "No run matches.");
    return element("section.card.runs", {}, shown, this.none);
  }

  row(run) {
    const href = `#${encodeURIComponent(run.scenario)}`;
    const [lap, clearance, pace] = [run.times?.lap_time, run.minimum_clearance, run.real_time_factor];
    const drivers = who(run);
    const cells = [
      pathPicture(run.thumbnail, THUMBNAIL),
      element("div.name", {}, element("a", { href }, run.scenario), ...about(run).map((text) => element("p", {}, text))),
      drivers.length ? element("div", {}, ...drivers) : NOTHING,
      element("span", {}, badge(run), ` ${verdictText(run)}`),
      formatNumber(lap, 3, "s"),
      formatNumber(clearance, 3, "m"),
      pace ? `${formatNumber(pace, 1)}×` : NOTHING,
      this.change(run),
    ];
    const change = run.previous ? cells[7].textContent ?? cells[7] : null;
    const keys = [null, run.scenario, cells[2].textContent ?? null, verdictText(run), lap ?? null, clearance ?? null, pace ?? null, change];
    return { cells, keys, click: () => { location.hash = href; } };
  }

  change(run) {
    const { previous } = run;
    if (!previous) return NOTHING;
    if (previous.passed !== run.passed) {
      return element(`span.change.${run.passed ? "better" : "worse"}`, {}, run.passed ? "mended" : "broken");
    }
    if (droveTheSame(run)) return "same";
    const [lap] = MEASURES;
    return changeOf(lap.of(run), lap.of(previous), lap.digits, lap.unit, lap.better) || "drove differently";
  }

  filter() {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const { run, row } of this.rows) {
      const text = `${run.world} ${row.textContent} ${run.description}`.toLowerCase();
      const kinds = [ALL, run.verdict, run.passed ? "" : FAILED];
      row.hidden = !words.every((word) => text.includes(word)) || !kinds.includes(this.kind.value);
      shown += Number(!row.hidden);
    }
    this.none.hidden = shown > 0;
  }

  load() {}

  close() {}
}

function headline(passed, count) {
  const scenarios = count === 1 ? "scenario" : "scenarios";
  if (passed < count) return `${count - passed} of ${count} ${scenarios} did not end as expected`;
  return count === 1 ? "The scenario ended as expected" : `All ${count} scenarios ended as expected`;
}

// What a run was about if it passed, else everything that went wrong.
function about(run) {
  if (run.passed) return [run.description];
  const failed = failedBesides(run);
  const why = failed.some(({ reason }) => reason === run.reason) ? [] : [run.reason];
  return [...why, ...failed.map((each) => `${each.name}: ${comparisonText(each)}`)];
}
