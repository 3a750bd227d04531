// The report: which page is shown, and the data behind it.

class Report {
  constructor({ created, runs }) {
    this.created = created;
    this.runs = runs;
    this.decoded = new Map();
  }

  replay(index) {
    return this.decode(`replay-${index}`);
  }

  // The run to compare with; nothing if it drove the same, as it could not be seen.
  previous(index) {
    const run = this.runs[index];
    return run.previous && !droveTheSame(run) ? this.decode(`previous-${index}`) : null;
  }

  // A run is decoded when it is opened first.
  decode(name) {
    if (!this.decoded.has(name)) {
      this.decoded.set(name, decodeColumns(embedded(name)).then((columns) => new Run(columns)));
    }
    return this.decoded.get(name);
  }
}

function embedded(name) {
  return JSON.parse(document.getElementById(name).textContent);
}

function start() {
  const report = new Report(embedded("overview"));
  const main = document.getElementById("page");
  let page = null;
  const show = () => {
    const name = decodeURIComponent(location.hash.slice(1));
    const index = report.runs.findIndex((run) => run.scenario === name);
    page?.close();
    page = index < 0 ? new Overview(report) : new RunPage(report, index);
    document.title = index < 0 ? "Scenario report" : `${formatName(name)} – scenario report`;
    main.replaceChildren(page.root);
    scrollTo(0, 0);
    return page.load();
  };
  addEventListener("hashchange", show);
  return show();
}

start();
