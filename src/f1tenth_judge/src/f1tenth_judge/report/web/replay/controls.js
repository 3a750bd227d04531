// What plays a replay: buttons, time line, speed and what is drawn.

import { element } from "../base/elements.js";
import { formatClock, formatNumber } from "../base/format.js";
import { LEAD } from "../data/events.js";
import { SPEEDS } from "./player.js";
import { DELTA_COLOURS, SPEED_COLOURS } from "./shades.js";

const PARTS = [["scan", "scan"], ["plans", "plans"], ["drawings", "markers"], ["ghost", "reference"], ["follow", "follow"]];

export class Controls {
  // `events` are marked on the time line; `extra` stands among the buttons; `onLink` puts the address of the moment where it can be copied.
  constructor({ player, view, events, extra, onLink }) {
    this.player = player;
    this.view = view;
    this.button = element("button.play", { type: "button", click: () => player.toggle() });
    this.slider = this.makeSlider();
    this.clock = element("output.clock");
    this.speed = element("select", { "aria-label": "speed", change: () => player.setSpeed(Number(this.speed.value)) },
      ...SPEEDS.map((speed) => element("option", { value: speed }, `${speed}×`)));
    this.toggles = PARTS.map(([part, text]) => this.toggleButton(part, text));
    this.root = element("div.controls", {},
      element("div.transport", {}, this.button, element("div.timeline", {}, this.slider, ...this.marks(events)), this.clock),
      element("div.toggles", {}, this.speed, this.slowButton(), ...this.toggles, extra,
        element("button", { type: "button", title: "address of this moment", click: onLink }, "link"),
        element("span.spring"), this.legend()));
  }

  makeSlider() {
    const slider = element("input.scrub", {
      type: "range", min: 0, max: this.player.end, step: 0.025, value: 0, "aria-label": "time",
      input: () => this.player.seek(Number(slider.value)), keydown: keepFromSlider,
    });
    return slider;
  }

  // Each leads to the moment before it.
  marks(events) {
    const { player } = this;
    return events.filter(({ time }) => time <= player.end).map(({ time, kind, text }) => element(`button.mark-at.${kind}`, {
      type: "button", title: text, "aria-label": text, style: `--at: ${time / player.end}`, click: () => player.seek(time - LEAD),
    }));
  }

  slowButton() {
    const { player } = this;
    if (!player.slow.length) return null;
    const toggle = (event) => {
      player.inSlowMotion = !player.inSlowMotion;
      event.target.setAttribute("aria-pressed", String(player.inSlowMotion));
    };
    return element("button.toggle", { type: "button", "aria-pressed": "true", title: "the last second before a contact", click: toggle }, "slow motion");
  }

  toggleButton(part, text) {
    return element("button.toggle", { type: "button", "data-part": part, click: () => this.toggle(part) }, text);
  }

  toggle(part) {
    this.view.toggle(part);
    this.player.onChange();
  }

  legend() {
    this.fastest = element("span");
    this.speeds = ramp("0", SPEED_COLOURS, this.fastest);
    this.deltas = ramp("gains time", DELTA_COLOURS, "loses");
    return element("span", {}, this.speeds, this.deltas);
  }

  draw() {
    const { player, view } = this;
    this.slider.max = player.end;
    this.slider.value = player.time;
    this.fastest.textContent = formatNumber(view.fastest, 1, "m/s");
    const isDelta = view.run.cars[0].delta.length > 0;
    this.speeds.hidden = isDelta || view.isRace;
    this.deltas.hidden = !isDelta || view.isRace;
    this.clock.textContent = `${formatClock(player.time)} / ${formatClock(player.end)}`;
    this.speed.value = player.speed;
    this.button.textContent = player.playing ? "❚❚" : "▶";
    this.button.setAttribute("aria-label", player.playing ? "pause" : "play");
    for (const toggle of this.toggles) toggle.setAttribute("aria-pressed", String(view.shown[toggle.dataset.part]));
    this.toggleOf("ghost").hidden = !view.ghost;
    this.toggleOf("drawings").hidden = !view.run.drawings.length;
    this.toggleOf("drawings").title = view.run.drawings.map(({ topic }) => topic).join(", ");
  }

  toggleOf(part) {
    return this.toggles.find(({ dataset }) => dataset.part === part);
  }
}

function ramp(low, colours, high) {
  return element("span.legend", {}, low, element("span.ramp", { style: `background: linear-gradient(90deg, ${colours.join(", ")})` }), high);
}

// Arrow keys mean the same on the slider as everywhere else on the page.
function keepFromSlider(event) {
  if (event.key.startsWith("Arrow") || event.key === "Home" || event.key === "End") event.preventDefault();
}
