// The report: which page is shown, and the data behind it.

import { decodeColumns, unpack } from "./base/decode.js";
import { LiveRuns } from "./data/live.js";
import { Run } from "./data/run.js";
import { LivePage } from "./pages/live_page.js";
import { Overview } from "./pages/overview.js";
import { RunPage } from "./pages/run_page.js";
import { WallPage } from "./pages/wall_page.js";
import { droveTheSame } from "./pages/words.js";

class Report {
  constructor({ created, runs, title = "Scenario report" }) {
    this.created = created;
    this.title = title;
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

// The address of a moment is #RUN?t=SECONDS.
function readHash() {
  const [name, query] = location.hash.slice(1).split("?");
  const time = new URLSearchParams(query).get("t");
  return { name: decoded(name), time: time === null ? null : Number(time) || 0 };
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
  const live = report.runs[0].live ? new LiveRuns(report.runs) : null;
  const main = document.getElementById("page");
  let page = null;
  const show = () => {
    const { name, time } = readHash();
    const index = live && report.runs.length === 1 ? 0 : report.runs.findIndex((run) => run.scenario === name);
    page?.close();
    page = live ? livePage(report, index, live) : reportPage(report, index, time);
    document.title = index < 0 ? report.title : `${report.runs[index].scenario} – ${live ? "live" : "scenario report"}`;
    main.replaceChildren(page.root);
    scrollTo(0, 0);
    return page.load();
  };
  addEventListener("hashchange", show);
  if (live) listen(live, () => page);
  return show();
}

function reportPage(report, index, time) {
  return index < 0 ? new Overview(report) : new RunPage(report, index, time);
}

function livePage(report, index, live) {
  return index < 0 ? new WallPage(report.title, live) : new LivePage(report, index, live);
}

// What is new is told to the page that is shown.
function listen(live, page) {
  live.watcher = {
    onState: (name) => page().onState(name),
    onBegin: (name) => page().onBegin(name),
    onNews: (name, events) => page().onNews(name, events),
    onEnd: (end) => {
      page().onEnd();
      if (end.page) location.replace(end.page);
    },
  };
  live.listen();
}

start();
