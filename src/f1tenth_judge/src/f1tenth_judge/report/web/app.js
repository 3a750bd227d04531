// The report: which page is shown, and the data behind it.

import { decodeColumns, unpack } from "./base/decode.js";
import { Run } from "./data/run.js";
import { LivePage } from "./pages/live_page.js";
import { Overview } from "./pages/overview.js";
import { RunPage } from "./pages/run_page.js";
import { droveTheSame } from "./pages/words.js";

class Report {
  constructor({ created, runs }) {
    this.created = created;
    this.runs = runs;
    this.decoded = new Map();
  }

  async replay(index) {
    const [columns, world] = await Promise.all([
      this.columns(`replay-${index}`), this.columns(`world-${this.runs[index].world_id}`),
    ]);
    return new Run(columns, world);
  }

  // The run to compare with; nothing if it drove the same, as it could not be seen.
  async previous(index) {
    const run = this.runs[index];
    return run.previous && !droveTheSame(run) ? new Run(await this.columns(`previous-${index}`)) : null;
  }

  // Decoded when they are needed first.
  columns(name) {
    if (!this.decoded.has(name)) this.decoded.set(name, unpack(embedded(name)).then(decodeColumns));
    return this.decoded.get(name);
  }
}

function embedded(name) {
  return document.getElementById(name).textContent;
}

export // The address of a moment is #RUN?t=SECONDS.
function readHash() {
  const [name, query] = location.hash.slice(1).split("?");
  return { name: decoded(name), time: Number(new URLSearchParams(query).get("t")) || 0 };
}

// Anybody may write an address by hand; no run has the name that cannot be read.
function decoded(name) {
  try {
    return decodeURIComponent(name);
  } catch {
    return name;
  }
}

async function start() {
  const report = new Report(await unpack(embedded("overview")));
  const main = document.getElementById("page");
  if (report.runs[0].live) return showLive(report, main);
  let page = null;
  const show = () => {
    const { name, time } = readHash();
    const index = report.runs.findIndex((run) => run.scenario === name);
    page?.close();
    page = index < 0 ? new Overview(report) : new RunPage(report, index, time);
    document.title = index < 0 ? "Scenario report" : `${name} – scenario report`;
    main.replaceChildren(page.root);
    scrollTo(0, 0);
    return page.load();
  };
  addEventListener("hashchange", show);
  return show();
}

function showLive(report, main) {
  const page = new LivePage(report, 0, 0);
  document.title = `${report.runs[0].scenario} – live`;
  main.replaceChildren(page.root);
  return page.load();
}

start();
