// The top view: a canvas whose still parts are drawn once and copied under the moving ones.

import { element, themeColours } from "../base/elements.js";
import { listenToPointers } from "../base/pointers.js";
import { indexAfter } from "../data/geometry.js";
import { drawMoving } from "./moving.js";
import { Painter } from "./painter.js";
import { shadesOf } from "./shades.js";
import { Viewport, boundingBox, boxOfStretch } from "./viewport.js";

const MARK = 19; // px, of goals and corners
const SMALL = 9; // px, of a car's length that is hard to find

export class View {
  // `run` has at least one car.
  constructor(run, contacts, corners) {
    this.run = run;
    this.ghost = null;
    this.corners = corners;
    this.contacts = contacts;
    this.shown = { scan: true, plans: true, drawings: true, ghost: true, follow: false };
    this.measure();
    this.viewport = new Viewport(boundingBox(run));
    this.canvas = element("canvas.map", { tabindex: "0", "aria-label": "Replay, seen from above" });
    this.still = document.createElement("canvas");
    this.time = 0;
    this.stretch = null;
    listenToPointers(this.canvas, this);
  }

  get aspect() {
    const { left, right, bottom, top } = this.viewport.box;
    return (right - left) / (top - bottom);
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    this.ratio = window.devicePixelRatio || 1;
    for (const canvas of [this.canvas, this.still]) {
      canvas.width = Math.round(clientWidth * this.ratio);
      canvas.height = Math.round(clientHeight * this.ratio);
    }
    this.viewport.resize(clientWidth, clientHeight);
    this.followWhereSmall();
    this.refresh();
  }

  measure() {
    const [first] = this.run.cars;
    this.fastest = Math.max(0.1, ...this.run.cars.map((car) => car.speed.reduce((most, each) => Math.max(most, each), 0)));
    this.shading = shadesOf(first, this.fastest);
  }

  // The run that this one is compared with, or nothing; `delta` of the cars fits it.
  setGhost(ghost) {
    this.ghost = ghost;
    this.grow();
  }

  // Shows where the cars were in a stretch of time {from, to} (s), that is told from the rest of their ways; null: all.
  setStretch(stretch) {
    if (!stretch && !this.stretch) return;
    this.stretch = stretch;
    if (!this.shown.follow) this.viewport.fit(stretch ? boxOfStretch(this.run, stretch) : undefined);
    this.refresh();
  }

  // The run has become longer, or is compared with another one.
  grow() {
    this.measure();
    this.refresh();
  }

  // On a long road a car is too small to be seen unless the view follows it.
  followWhereSmall() {
    const [car] = this.run.cars;
    if (this.decided || !this.canvas.clientWidth) return;
    this.decided = true;
    this.shown.follow = this.viewport.scale * (car.body.front - car.body.rear) < SMALL;
  }

  toggle(part) {
    this.shown[part] = !this.shown[part];
    if (part === "follow" && !this.shown.follow) this.viewport.fit();
    this.refresh();
  }

  fit() {
    this.shown.follow = false;
    this.viewport.fit();
    this.refresh();
  }

  // Everything anew: after a change of size, colours or what is shown.
  refresh() {
    this.colours = themeColours();
    this.stale = true;
    this.draw(this.time);
  }

  draw(time) {
    this.time = time;
    if (!this.canvas.width) return;
    this.states = this.run.cars.map((car) => car.at(time));
    if (this.shown.follow && this.states.length) {
      this.viewport.follow(this.states[0]);
      this.stale = true;
    }
    if (this.stale) this.drawStill();
    const context = this.canvas.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(this.still, 0, 0);
    drawMoving(this.painter(context), this);
  }

  painter(context) {
    this.viewport.apply(context, this.ratio);
    return new Painter(context, this.viewport.scale, this.colours);
  }

  drawStill() {
    this.stale = false;
    const context = this.still.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = this.colours.road;
    context.fillRect(0, 0, this.still.width, this.still.height);
    const painter = this.painter(context);
    const { x: left, y: top } = this.viewport.toMap({ x: 0, y: 0 });
    const { x: right, y: bottom } = this.viewport.toMap({ x: this.canvas.clientWidth, y: this.canvas.clientHeight });
    painter.grid({ left, right, bottom, top });
    painter.shape(this.run.walls, this.colours.wall);
    context.globalAlpha = this.stretch ? 0.2 : 0.7;
    this.drawPaths(painter);
    context.globalAlpha = 0.7;
    if (this.stretch) this.drawPaths(painter, this.stretch);
    context.globalAlpha = 1;
    this.drawMarks(painter);
  }

  drawPaths(painter, { from, to } = { from: -Infinity, to: Infinity }) {
    this.run.cars.forEach((car, index) => {
      const [first, last] = [Math.max(indexAfter(car.time, from) - 1, 0), indexAfter(car.time, to)];
      if (this.isRace) painter.strokeLine(car, this.colours.cars[index % 4], 1.5, first, last);
      else painter.path(car, this.shading, 2.5, first, last);
    });
  }

  // The paths of several cars are told apart by the colours of the cars, one path shows its speed.
  get isRace() {
    return this.run.cars.length > 1;
  }

  drawMarks(painter) {
    const drawn = new Map();
    for (const poses of this.run.goals) {
      poses.forEach(({ x, y }, index) => {
        const place = `${x} ${y}`;
        if (!drawn.has(place)) painter.marker(x, y, 8.5, this.colours.goal, String(index + 1));
        drawn.set(place, { x, y });
      });
    }
    for (const corner of this.corners) this.drawCorner(painter, corner, [...drawn.values()]);
    for (const { x, y } of this.contacts) painter.cross(x, y, 7);
  }

  // Above a goal that is in its place.
  drawCorner(painter, { x, y, number }, goals) {
    const room = MARK / this.viewport.scale;
    const isTaken = goals.some((goal) => Math.hypot(goal.x - x, goal.y - y) < room);
    painter.tag(x, isTaken ? y + room : y, `T${number}`);
  }

  pan(dx, dy) {
    this.shown.follow = false;
    this.viewport.pan(dx, dy);
    this.refresh();
  }

  zoom(factor, pixel) {
    this.viewport.zoom(factor, pixel);
    this.refresh();
  }
}
