// The page of one run: replay, charts, tables.

import { element } from "../base/elements.js";
import { Channels } from "../charts/channels.js";
import { cornersOf, lengthOf, whereOf } from "../compare/corners.js";
import { deltaTo } from "../compare/delta.js";
import { comparisonCard, contactsCard, cornersCard, criteriaCard, culpritCard, lapsCard, linksCard, interventionsCard, problemsCard, tiles, versionsCard } from "./cards.js";
import { besidesReason, lastSecondCard } from "./last_second.js";
import { referenceChoice } from "./reference.js";
import { badge, comparisonText, failedBesides, verdictText, who, winnerText } from "./words.js";
import { LEAD, decisionOf, eventsOf, slowParts } from "../data/events.js";
import { Cameras } from "../replay/cameras.js";
import { Controls } from "../replay/controls.js";
import { handleKey, keyHelp } from "../replay/keyboard.js";
import { Player } from "../replay/player.js";
import { View } from "../replay/view.js";

const STAGE_MARGIN = 12; // px, to the ends of the window

export class RunPage {
  // `time` (s): what is shown first; null: what decided the run, or its beginning.
  constructor(report, index, time) {
    this.report = report;
    this.time = time;
    this.index = index;
    this.result = report.runs[index];
    this.events = eventsOf(this.result);
    this.decision = this.result.live ? null : decisionOf(this.result);
    this.stage = element("section.card.stage", { "aria-busy": "true" }, element("p.note", {}, "Reading the recording…"));
    this.root = element("div.run", {}, this.header(), this.stage, element("div.facts", {}, ...this.cards()));
    this.onResize = () => this.resize();
    this.onKey = (event) => this.player && handleKey(this, event);
    this.scheme = matchMedia("(prefers-color-scheme: dark)");
    this.onScheme = () => this.refresh();
  }

  header() {
    const { result } = this;
    return element("header.run-head", {},
      element("nav", {},
        result.live && this.report.runs.length === 1 ? null : element("a", { href: "#" }, "← All runs"),
        element("span.spring"),
        this.neighbour(-1, "←"), this.neighbour(1, "→")),
      element("h1", {}, result.scenario, result.live ? null : badge(result)),
      element("p.lead", {}, result.description),
      element("p.drivers", {}, ...who(result)),
      ...this.outcome(),
      result.live ? null : tiles(result));
  }

  // The verdict and why, and every criterion that failed besides.
  outcome() {
    const { result } = this;
    const failed = failedBesides(result);
    const why = failed.some(({ reason }) => reason === result.reason) ? "" : ` — ${result.reason}`;
    return [
      element(`p.reason.${result.passed ? "good" : "bad"}`, {}, element("b", {}, verdictText(result)), why),
      ...failed.map((each) => element("p.reason.bad", {}, element("b", {}, each.name), ` — ${each.reason} (${comparisonText(each)})`)),
      result.winner ? element("p.reason", {}, winnerText(result)) : null,
    ];
  }

  neighbour(step, arrow) {
    const other = this.report.runs[this.index + step];
    if (!other) return null;
    const title = `${step > 0 ? "next" : "previous"}: ${other.scenario}`;
    return element("a.step", { href: `#${encodeURIComponent(other.scenario)}`, title, "aria-label": title }, arrow);
  }

  cards() {
    const { result } = this;
    this.cornersPlace = element("div");
    this.lastSecondPlace = element("div");
    this.contactsPlace = element("div", {}, contactsCard(result, this.seek, () => ""));
    return [
      problemsCard(result), culpritCard(result), this.lastSecondPlace, criteriaCard(result), comparisonCard(result), this.cornersPlace, lapsCard(result),
      this.contactsPlace, interventionsCard(result, this.seek), linksCard(result), versionsCard(result), keyHelp(),
    ].filter(Boolean);
  }

  seek = (time) => {
    this.player?.seek(time);
    this.stage.scrollIntoView({ block: "nearest" });
  };

  /** @returns {void | Promise<void>} */
  load() {
    return this.read();
  }

  async read() {
    const [run, ghost] = await Promise.all([this.report.replay(this.index), this.report.previous(this.index)]);
    if (!this.closed) this.show(run);
    if (ghost && !this.closed) this.compare(ghost, this.result.previous);
  }

  show(run) {
    if (!run.cars.length) {
      this.stage.replaceChildren(element("p.note", {}, "Nothing was recorded."));
      this.stage.removeAttribute("aria-busy");
      return;
    }
    this.player = new Player(run.end, slowParts(this.events), () => this.draw());
    this.corners = run.road.x.length ? cornersOf(run.road) : [];
    this.view = new View(run, this.result.contacts ?? [], this.corners);
    this.cameras = new Cameras(run.pictures);
    this.channels = this.makeChannels(null);
    const choice = referenceChoice(this.report, this.index, (ghost, result) => this.compare(ghost, result));
    this.controls = new Controls({ player: this.player, view: this.view, events: this.events, extra: choice, onLink: () => this.link() });
    this.stage.replaceChildren(this.view.canvas, this.cameras.root, this.controls.root, this.channels.root);
    this.showCorners(null, null);
    this.showPlaces();
    this.stage.removeAttribute("aria-busy");
    this.view.canvas.style.aspectRatio = Math.min(Math.max(this.view.aspect, 1), 2.4);
    addEventListener("resize", this.onResize);
    addEventListener("keydown", this.onKey);
    this.scheme.addEventListener("change", this.onScheme);
    this.resize();
    this.player.seek(this.time ?? Math.max((this.decision?.time ?? 0) - LEAD, 0));
  }

  // Lays another run over this one; `result` is that of the other. Both nothing: none.
  compare(ghost, result) {
    for (const car of this.view.run.cars) {
      const other = ghost?.cars.find(({ name }) => name === car.name) ?? ghost?.cars[0];
      car.delta = other?.way.length && car.way.length ? deltaTo(car, other) : new Float64Array();
    }
    const before = this.channels;
    this.channels = this.makeChannels(ghost);
    before.root.replaceWith(this.channels.root);
    this.channels.resize();
    this.channels.showAs(before);
    this.view.setGhost(ghost);
    this.showCorners(ghost, result);
    this.draw();
  }

  showCorners(ghost, result) {
    const own = { run: this.view.run, result: this.result };
    const card = cornersCard(this.corners, own, ghost && { run: ghost, result }, (time) => this.player.seek(time));
    this.cornersPlace.replaceChildren(...[card].filter(Boolean));
  }

  // Says in which corner something happened.
  showPlaces() {
    const { run } = this.view;
    const carOf = (name) => run.cars.find((each) => each.name === name);
    const whereWas = (car, time) => (car ? whereOf(this.corners, lengthOf(run.road), car.at(time).way) : "");
    const where = ({ car, start }) => whereWas(carOf(car), start);
    this.contactsPlace?.replaceChildren(...[contactsCard(this.result, this.seek, where)].filter(Boolean));
    if (!this.decision) return;
    const car = carOf(this.decision.car) ?? run.cars[0];
    this.root.querySelector(".reason").append(besidesReason(this.result.reason, this.decision, car, whereWas(car, this.decision.time)));
    this.lastSecondPlace.replaceChildren(lastSecondCard(this.decision, car, run.road));
  }

  makeChannels(ghost) {
    const limit = this.result.criteria.find(({ name }) => name === "minimum_clearance")?.limit;
    const on = { onSeek: (time) => this.player.seek(time), onSpan: (times) => this.view.setStretch(times) };
    return new Channels(this.view.run, ghost, { clearance: limit }, on);
  }

  // Puts the address of this moment where it can be copied.
  link() {
    history.replaceState(null, "", `#${encodeURIComponent(this.result.scenario)}?t=${this.player.time.toFixed(3)}`);
    navigator.clipboard?.writeText(location.href).catch(() => {});
  }

  step(direction, event) {
    this.player.seek(this.player.time + direction * (event.shiftKey ? 0.1 : 1));
  }

  // The whole map, and all of the charts.
  fit() {
    this.channels.span.show(null);
    this.view.fit();
  }

  open(step) {
    const other = this.report.runs[this.index + step];
    if (other) location.hash = encodeURIComponent(other.scenario);
  }

  resize() {
    this.view.resize();
    this.channels.resize();
    // Whose stage is higher than the window scrolls to its end before it stays.
    this.stage.style.top = `${Math.min(STAGE_MARGIN, innerHeight - this.stage.offsetHeight - STAGE_MARGIN)}px`;
    this.draw();
  }

  refresh() {
    this.view.refresh();
    this.channels.refresh();
  }

  draw() {
    const { player, view } = this;
    view.draw(player.time);
    this.cameras.draw(player.time);
    this.channels.draw(player.time);
    this.controls.draw();
    const [first] = view.states;
    this.stage.dataset.pose = `${first.x.toFixed(3)} ${first.y.toFixed(3)}`;
  }

  close() {
    this.closed = true;
    this.stop();
  }

  // What a replay keeps going.
  stop() {
    this.player?.pause();
    removeEventListener("resize", this.onResize);
    removeEventListener("keydown", this.onKey);
    this.scheme.removeEventListener("change", this.onScheme);
  }
}
