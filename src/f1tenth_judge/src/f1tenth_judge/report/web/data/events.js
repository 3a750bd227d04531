// What happened to a run at a moment, as its result has it.

import { formatNumber } from "../base/format.js";

export const LEAD = 1; // s before an event from which it is worth being seen

// In order: {time (s), kind, text}.
export function eventsOf({ contacts = [], interventions = [], off_road: excursions = [] }) {
  const events = [
    ...contacts.map(({ start, car, touched }) => ({ time: start, kind: "contact", text: `${car} touched ${touched.join(" and ")}` })),
    ...interventions.map(({ time, kind, caller, model }) => ({ time, kind: "intervention", text: `${caller} called ${kind}${model && ` for ${model}`}` })),
    ...excursions.map(({ start, car }) => ({ time: start, kind: "off-road", text: `${car} left the road` })),
  ];
  return events.sort((one, other) => one.time - other.time).map((event) => ({ ...event, text: `${event.text} at ${formatNumber(event.time, 3, "s")}` }));
}
