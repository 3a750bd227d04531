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

// What decided a run that did not pass: when (s) and the car that it happened to, null if nobody says; null if nothing did.
export function decisionOf({ passed, verdict, contacts = [], times, culprit }) {
  if (passed || verdict === "success") return null;
  const [first] = contacts;
  if (first && !(first.start > times?.finish)) return { time: first.start, car: first.car };
  return lastMoment(culprit, times);
}

function lastMoment(culprit, times) {
  const time = culprit?.stamp ?? times?.finish;
  return typeof time === "number" ? { time, car: culprit?.culprit.split("/")[0] ?? null } : null;
}

// Stretches of time that are worth being seen slowly.
export function slowParts(events) {
  return events.filter(({ kind }) => kind === "contact").map(({ time }) => ({ from: time - LEAD, to: time }));
}
