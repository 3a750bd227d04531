// Keys of a replay.

import { element } from "../base/elements.js";

const KEYS = [
  { keys: [" "], shown: "space", help: "play, pause", act: (page) => page.player.toggle() },
  { keys: ["ArrowLeft"], shown: "←", help: "back 1 s, with shift 0.1 s", act: (page, event) => page.step(-1, event) },
  { keys: ["ArrowRight"], shown: "→", help: "on 1 s, with shift 0.1 s", act: (page, event) => page.step(1, event) },
  { keys: ["Home"], shown: "Home", help: "to the start", act: (page) => page.player.seek(0) },
  { keys: ["End"], shown: "End", help: "to the end", act: (page) => page.player.seek(page.player.end) },
  { keys: ["ArrowUp"], shown: "↑", help: "faster", act: (page) => page.player.changeSpeed(1) },
  { keys: ["ArrowDown"], shown: "↓", help: "slower", act: (page) => page.player.changeSpeed(-1) },
  { keys: ["f"], shown: "F", help: "follow the car", act: (page) => page.controls.toggle("follow") },
  { keys: ["s"], shown: "S", help: "scan", act: (page) => page.controls.toggle("scan") },
  { keys: ["p"], shown: "P", help: "plans", act: (page) => page.controls.toggle("plans") },
  { keys: ["m"], shown: "M", help: "the planner's markers", act: (page) => page.controls.toggle("drawings") },
  { keys: ["g"], shown: "G", help: "the run before", act: (page) => page.controls.toggle("ghost") },
  { keys: ["+", "="], shown: "+", help: "charts: zoom in at the moment shown", act: (page) => page.channels.zoom(2) },
  { keys: ["-"], shown: "−", help: "charts: zoom out", act: (page) => page.channels.zoom(1 / 2) },
  { keys: [","], shown: ",", help: "charts: to the left", act: (page) => page.channels.pan(-1) },
  { keys: ["."], shown: ".", help: "charts: to the right", act: (page) => page.channels.pan(1) },
  { keys: ["0"], shown: "0", help: "whole map and charts", act: (page) => page.fit() },
  { keys: ["j"], shown: "J", help: "next run", act: (page) => page.open(1) },
  { keys: ["k"], shown: "K", help: "run before it", act: (page) => page.open(-1) },
  { keys: ["Escape"], shown: "Esc", help: "all runs", act: () => { location.hash = ""; } },
];

export function handleKey(page, event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const binding = KEYS.find(({ keys }) => keys.includes(name));
  if (!binding) return;
  event.preventDefault();
  binding.act(page, event);
}

export function keyHelp() {
  const entries = KEYS.flatMap(({ shown, help }) => [element("dt", {}, element("kbd", {}, shown)), element("dd", {}, help)]);
  return element("details.keys", {}, element("summary", {}, "Keys"), element("dl", {}, ...entries));
}
