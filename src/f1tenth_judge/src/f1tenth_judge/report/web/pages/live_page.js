// The page of a run that goes on; when all end, the page becomes the report.

import { element } from "../base/elements.js";
import { keyHelp } from "../replay/keyboard.js";
import { section } from "./cards.js";
import { RunPage } from "./run_page.js";
import { verdictText, who } from "./words.js";

const REDRAW = 500; // ms, between two times that what stands still is drawn anew
const MOST_EVENTS = 200; // in the list, and contacts on the map: the latest

export class LivePage extends RunPage {
  // `live`: a LiveRuns.
  constructor(report, index, live) {
    super(report, index, 0);
    this.live = live;
  }

  cards() {
    this.log = element("ul");
    this.logCard = section("Events", this.log);
    this.logCard.hidden = true;
    this.cornersPlace = element("div");
    return [this.logCard, keyHelp()];
  }

  outcome() {
    this.said = element("p.reason", {}, "Not begun yet.");
    return [this.said];
  }

  load() {
    this.onState(this.result.scenario);
    if (this.live.driven.has(this.result.scenario)) this.onBegin(this.result.scenario);
    else if (this.result.state === "over") this.stage.replaceChildren(element("p.note", {}, "Its replay will be in the report, when all runs are over."));
  }

  onState(name) {
    const { state } = this.result;
    if (name !== this.result.scenario || !state) return;
    this.said.textContent = { waiting: "Not begun yet.", driving: "Driving now." }[state] ?? `Over: ${verdictText(this.result)}.`;
  }

  onBegin(name) {
    if (name !== this.result.scenario) return;
    const run = this.live.driven.get(name);
    this.stop();
    this.result.contacts = [];
    this.events.length = 0;
    this.log.replaceChildren();
    this.root.querySelector(".lead").textContent = this.result.description;
    this.root.querySelector(".drivers").replaceChildren(...who(this.result));
    this.time = run.end;
    this.show(run);
  }

  // Who looks at the latest moment goes on doing so; who has gone back stays there.
  onNews(name, events) {
    if (name !== this.result.scenario) return;
    const { player, view } = this;
    const isLatest = player.time >= player.end - 0.1;
    player.end = view.run.end;
    for (const event of events) this.note(event);
    if (!(performance.now() - this.redrawn < REDRAW)) this.redraw();
    if (isLatest && !player.playing) player.seek(player.end);
    else this.controls.draw();
  }

  note(event) {
    const { contacts } = this.view;
    this.logCard.hidden = false;
    this.log.prepend(element("li", {}, `${event.time.toFixed(2)} s: ${event.text}`));
    if (this.log.children.length > MOST_EVENTS) this.log.lastChild.remove();
    if (event.kind === "contact") contacts.push(event);
    if (contacts.length > MOST_EVENTS) contacts.shift();
  }

  redraw() {
    this.redrawn = performance.now();
    this.view.grow();
    this.channels.grow();
  }

  onEnd() {
    this.said.textContent = "The run is over.";
  }
}
