// The page of a run that goes on; when it ends, the page becomes the report.

import { element } from "../base/elements.js";
import { LiveRun } from "../data/live.js";
import { keyHelp } from "../replay/keyboard.js";
import { section } from "./cards.js";
import { RunPage } from "./run_page.js";

const REDRAW = 500; // ms, between two times that what stands still is drawn anew

export class LivePage extends RunPage {
  cards() {
    this.log = element("ul");
    this.logCard = section("Events", this.log);
    this.logCard.hidden = true;
    this.cornersPlace = element("div");
    return [this.logCard, keyHelp()];
  }

  outcome() {
    this.said = element("p.reason", {}, "Driving now.");
    return [this.said];
  }

  load() {
    this.live = new LiveRun((run) => this.begin(run), (events) => this.grow(events), (end) => this.end(end));
  }

  begin(run) {
    this.stop();
    this.result.contacts = [];
    this.events.length = 0;
    this.log.replaceChildren();
    this.time = run.end;
    this.show(run);
  }

  // Who looks at the latest moment goes on doing so; who has gone back stays there.
  grow(events) {
    const { player, view } = this;
    const isLatest = player.time >= player.end - 0.1;
    player.end = view.run.end;
    for (const event of events) this.note(event);
    if (!(performance.now() - this.redrawn < REDRAW)) this.redraw();
    if (isLatest && !player.playing) player.seek(player.end);
    else this.controls.draw();
  }

  note(event) {
    this.logCard.hidden = false;
    this.log.prepend(element("li", {}, `${event.time.toFixed(2)} s: ${event.text}`));
    if (event.kind === "contact") this.view.contacts.push(event);
  }

  redraw() {
    this.redrawn = performance.now();
    this.view.grow();
    this.channels.each((chart) => chart.grow());
  }

  end({ page }) {
    this.said.textContent = "The run is over.";
    if (page) location.replace(page);
  }

  close() {
    super.close();
    this.live?.close();
  }
}
