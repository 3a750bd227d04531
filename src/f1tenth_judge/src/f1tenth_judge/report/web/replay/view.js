// The top view: a canvas whose still parts are drawn once and copied under the moving ones.

import { element, themeColours } from "../base/elements.js";
import { indexAfter } from "../data/geometry.js";
import { listenToPointers } from "./pointers.js";
import { Painter } from "./painter.js";
import { shadesOf } from "./shades.js";
import { Viewport, boundingBox } from "./viewport.js";

const TRAIL = 1.5; // s of the path behind a car that is drawn bold
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
    this.drawMoving(this.painter(context));
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
    context.globalAlpha = 0.7;
    if (this.isRace) this.run.cars.forEach((car, index) => painter.strokeLine(car, this.colours.cars[index % 4], 1.5));
    else painter.path(this.run.cars[0], this.shading.shades, this.shading.colours, 2.5);
    context.globalAlpha = 1;
    this.drawMarks(painter);
  }

  // The paths of several cars are told apart by the colours of the cars, one path shows its speed.
  get isRace() {
    return this.run.cars.length > 1;
  }

  drawMarks(painter) {
    const drawn = new Set();
    for (const poses of this.run.goals) {
      poses.forEach(({ x, y }, index) => {
        const place = `${x} ${y}`;
        if (!drawn.has(place)) painter.marker(x, y, 8.5, this.colours.goal, String(index + 1));
        drawn.add(place);
      });
    }
    for (const { x, y, number } of this.corners) painter.tag(x, y, `T${number}`);
    for (const { x, y } of this.contacts) painter.cross(x, y, 7);
  }

  drawMoving(painter) {
    const { run, shown, time } = this;
    if (shown.scan) this.drawScans(painter);
    for (const model of run.models) {
      const pose = run.modelPose(model, time);
      if (pose) painter.inFrame(pose, () => painter.shape(model.shape, this.colours.model));
    }
    if (shown.plans) this.drawPlans(painter);
    if (shown.drawings) this.drawDrawings(painter);
    if (shown.ghost && this.ghost) this.drawGhosts(painter);
    run.cars.forEach((car, index) => {
      const last = indexAfter(car.time, time);
      painter.strokeLine(car, this.isRace ? this.colours.cars[index % 4] : this.colours.text, 3.5, indexAfter(car.time, time - TRAIL), last);
    });
    run.cars.forEach((car, index) => {
      painter.car(this.states[index], car.body, this.colours.cars[index % 4]);
      if (this.isRace) this.drawName(painter, car, index);
    });
  }

  drawScans(painter) {
    for (const lidar of this.run.lidars) {
      painter.scan(lidar.points(lidar.car.at(this.time), this.run.obstacles(lidar.car, this.time)));
    }
  }

  drawPlans(painter) {
    const kinds = [[this.run.globalPlans, this.colours.globalPlan, 2], [this.run.localPlans, this.colours.localPlan, 3]];
    for (const [plans, colour, pixels] of kinds) {
      for (const { time, lines } of plans) {
        const index = indexAfter(time, this.time) - 1;
        if (index >= 0) painter.strokeLine(lines[index], colour, pixels);
      }
    }
  }

  drawDrawings(painter) {
    for (const { time, frames } of this.run.drawings) {
      const index = indexAfter(time, this.time) - 1;
      if (index >= 0) frames[index].forEach((drawing) => painter.drawing(drawing));
    }
  }

  drawGhosts(painter) {
    const bodies = new Map(this.run.cars.map(({ name, body }) => [name, body]));
    for (const car of this.ghost.cars) {
      painter.context.setLineDash([4 / painter.scale, 4 / painter.scale]);
      painter.strokeLine(car, this.colours.ghost, 1.5);
      painter.context.setLineDash([]);
      painter.car(car.at(this.time), bodies.get(car.name) ?? car.body, this.colours.ghost, 0.7);
    }
  }

  drawName(painter, car, index) {
    const { x, y } = this.states[index];
    painter.label(x, y, car.name, this.colours.text, 11, index % 2 ? 22 : -22); // beside a neighbour on the grid
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
