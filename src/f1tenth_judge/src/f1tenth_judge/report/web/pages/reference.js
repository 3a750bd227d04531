// The choice of the run that another one is compared with.

import { element } from "../base/elements.js";
import { formatNumber } from "../base/format.js";
import { commitName, droveTheSame, plannerName } from "./words.js";

// `onChoice` gets the run and its result, or nothing and nothing. Offered are the runs of the same world, and the one before.
export function referenceChoice(report, index, onChoice) {
  const { runs } = report;
  const result = runs[index];
  const others = runs.map((run, number) => ({ run, number })).filter(({ run, number }) => number !== index && run.world_id === result.world_id);
  const before = result.previous && !droveTheSame(result);
  const choose = async (value) => {
    if (value === "none") onChoice(null, null);
    else if (value === "previous") onChoice(await report.previous(index), result.previous);
    else onChoice(await report.replay(value), runs[value]);
  };
  if (!others.length && !before) return null;
  return element("select", { "aria-label": "reference", change: (event) => choose(event.target.value) },
    element("option", { value: "none" }, "no reference"),
    before ? element("option", { value: "previous", selected: true }, `the run before ${commitName(result.previous)}`) : null,
    ...others.map(({ run, number }) => element("option", { value: number }, nameOf(run))));
}

// Tells runs of one world apart: by name, planners and lap.
function nameOf(run) {
  const planners = Object.values(run.cars ?? {}).map(({ planner }) => planner && plannerName(planner)).filter(Boolean);
  const lap = run.times?.lap_time;
  return [run.scenario, planners.join(" + "), lap && formatNumber(lap, 3, "s")].filter(Boolean).join(" · ");
}
