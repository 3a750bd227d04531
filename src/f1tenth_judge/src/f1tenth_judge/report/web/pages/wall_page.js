// Many runs that go on, each as a small picture; a click enlarges it.

import { element } from "../base/elements.js";
import { formatNumber } from "../base/format.js";
import { View } from "../replay/view.js";
import { pathPicture } from "./thumbnail.js";
import { badge, verdictText, who } from "./words.js";

const REFRESH = 100; // ms, between two pictures of a run
const RESTING = { width: 240, height: 150, margin: 12 }; // px, of the path of a run that is over

class Tile {
  constructor(name, live) {
    this.name = name;
    this.live = live;
    this.picture = element("div.picture");
    this.about = element("div.about");
    this.root = element("a.tile", { href: `#${encodeURIComponent(name)}` }, this.picture, element("b", {}, name), this.about);
  }

  get result() {
    return this.live.results.get(this.name);
  }

  // Those that drive come first, those that wait last.
  stand() {
    const { state = "waiting" } = this.result;
    this.root.dataset.state = state;
    this.say();
    if (this.live.driven.has(this.name)) this.begin();
    else if (state !== "driving") this.rest();
  }

  say() {
    const { result } = this;
    const time = this.live.driven.get(this.name)?.end;
    const outcome = { waiting: ["waiting"], over: [badge(result), ` ${verdictText(result)}`] }[result.state ?? "waiting"] ?? [formatNumber(time, 1, "s")];
    this.about.replaceChildren(element("div", {}, ...outcome), ...who(result));
  }

  rest() {
    this.view = null;
    this.picture.replaceChildren(pathPicture(this.live.paths.get(this.name) ?? [], RESTING));
  }

  begin() {
    this.view = new View(this.live.driven.get(this.name), [], []);
    this.view.decided = true; // all of the map, however small the car is
    this.picture.replaceChildren(this.view.canvas);
    this.view.canvas.tabIndex = -1;
    this.resize();
  }

  resize() {
    this.view?.resize();
  }

  grow() {
    if (!this.view || performance.now() - this.drawn < REFRESH) return;
    this.drawn = performance.now();
    this.say();
    this.view.measure();
    this.view.time = this.view.run.end;
    this.view.refresh();
  }
}

export class WallPage {
  // `live`: a LiveRuns.
  constructor(title, live) {
    this.live = live;
    this.tiles = new Map([...live.results.keys()].map((name) => [name, new Tile(name, live)]));
    this.count = element("p.lead");
    this.root = element("div.wall", {},
      element("header.head", {}, element("h1", {}, title), this.count),
      element("div.tiles-of-runs", {}, ...[...this.tiles.values()].map(({ root }) => root)));
    this.onResize = () => this.tiles.forEach((tile) => tile.resize());
    this.scheme = matchMedia("(prefers-color-scheme: dark)");
  }

  load() {
    addEventListener("resize", this.onResize);
    this.scheme.addEventListener("change", this.onResize);
    for (const name of this.tiles.keys()) this.onState(name);
  }

  close() {
    removeEventListener("resize", this.onResize);
    this.scheme.removeEventListener("change", this.onResize);
  }

  onState(name) {
    this.tiles.get(name).stand();
    const states = [...this.live.results.values()].map(({ state }) => state);
    const number = (state) => states.filter((each) => each === state).length;
    this.count.textContent = `${number("driving")} driving, ${number("over")} of ${states.length} over`;
  }

  onBegin(name) {
    this.tiles.get(name).begin();
  }

  onNews(name) {
    this.tiles.get(name).grow();
  }

  onEnd() {
    this.count.textContent = "All are over.";
  }
}
