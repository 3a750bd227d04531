// What plays a replay: buttons, time line, speed and what is drawn.

import { element } from "../base/elements.js";
import { formatClock, formatNumber } from "../base/format.js";
import { LEAD } from "../data/events.js";
import { SPEED_COLOURS } from "./painter.js";
import { SPEEDS } from "./player.js";

const PARTS = [["scan", "scan"], ["plans", "plans"], ["ghost", "other run"], ["follow", "follow"]];

export class Controls {
  // `events` are marked on the time line; `onLink` puts the address of the moment where it can be copied.
  constructor({ player, view, events, onLink }) {
    this.player = player;
    this.view = view;
    this.button = element("button.play", { type: "button", click: () => player.toggle() });
    this.slider = this.makeSlider();
    this.clock = element("output.clock");
    this.speed = element("select", { "aria-label": "speed", change: () => player.setSpeed(Number(this.speed.value)) },
      ...SPEEDS.map((speed) => element("option", { value: speed }, `${speed}×`)));
    this.fastest = element("span");
    this.toggles = PARTS.map(([part, text]) => this.toggleButton(part, text));
    this.root = element("div.controls", {},
      element("div.transport", {}, this.button, element("div.timeline", {}, this.slider, ...this.marks(events)), this.clock),
      element("div.toggles", {}, this.speed, this.slowButton(), ...this.toggles,
        element("button", { type: "button", title: "address of this moment", click: onLink }, "link"),
        element("span.spring"), view.isRace ? null : this.legend()));
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
    const colours = SPEED_COLOURS.join(", ");
    return element("span.legend", {}, "0", element("span.ramp", { style: `background: linear-gradient(90deg, ${colours})` }),
      this.fastest);
  }

  draw() {
    const { player, view } = this;
    this.slider.max = player.end;
    this.slider.value = player.time;
    this.fastest.textContent = formatNumber(view.fastest, 1, "m/s");
    this.clock.textContent = `${formatClock(player.time)} / ${formatClock(player.end)}`;
    this.speed.value = player.speed;
    this.button.textContent = player.playing ? "❚❚" : "▶";
    this.button.setAttribute("aria-label", player.playing ? "pause" : "play");
    for (const toggle of this.toggles) toggle.setAttribute("aria-pressed", String(view.shown[toggle.dataset.part]));
    this.toggles.find(({ dataset }) => dataset.part === "ghost").hidden = !view.ghost;
  }
}

// Arrow keys mean the same on the slider as everywhere else on the page.
function keepFromSlider(event) {
  if (event.key.startsWith("Arrow") || event.key === "Home" || event.key === "End") event.preventDefault();
}
