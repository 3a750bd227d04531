// Runs that go on: their data comes over Server-Sent Events, as runs.py says it.

import { decodeColumns, unpack } from "../base/decode.js";
import { Run } from "./run.js";

const COLUMNS = ["time", "x", "y", "yaw", "speed", "steering", "clearance"]; // of a row

export class LiveRuns {
  // `results`: of the runs, in the order in which they are shown.
  constructor(results) {
    this.results = new Map(results.map((result) => [result.scenario, result]));
    this.driven = new Map(); // the Run of each that drives, by name
    this.paths = new Map(); // of those that are over
    this.scenes = new Map();
    this.watcher = null;
  }

  // `watcher` is told: onBegin(name) when a simulation begins, onNews(name, events) when it has grown, onState(name),
  // and at the end of all onEnd(end).
  listen() {
    this.source = new EventSource("/events");
    this.on("scene", (scene) => this.scenes.set(scene.run, scene));
    this.on("standing", (standing) => this.stand(standing));
    this.on("news", (news) => this.take(news));
    this.on("end", (end) => {
      this.source.close();
      this.watcher.onEnd(end);
    });
  }

  // One after the other, although a scene takes time to be unpacked.
  on(kind, act) {
    this.source.addEventListener(kind, ({ data }) => {
      this.last = Promise.resolve(this.last).then(() => act(JSON.parse(data)));
    });
  }

  stand({ run: name, state, result, path }) {
    Object.assign(this.results.get(name), result, { state });
    this.paths.set(name, path);
    if (state !== "driving") {
      this.driven.delete(name);
      this.scenes.delete(name);
    }
    this.watcher.onState(name);
  }

  async take({ run: name, begins, cars, events, drawn }) {
    if (begins) await this.begin(name, Object.keys(cars));
    const run = this.driven.get(name);
    for (const car of run.cars) car.grow(cars[car.name] ?? [], COLUMNS);
    for (const { time, topic, drawn: frame } of drawn) run.draw(topic, time, decodeColumns(frame));
    run.end = Math.max(...run.cars.map((car) => car.end));
    if (begins) this.watcher.onBegin(name);
    this.watcher.onNews(name, events);
  }

  async begin(name, cars) {
    const { columns: packed, world, about } = this.scenes.get(name);
    const [columns, walls] = await Promise.all([unpack(packed), unpack(world)]);
    columns.cars = Object.fromEntries(cars.map((car) => [car, {}]));
    const run = new Run(decodeColumns(columns), decodeColumns(walls));
    for (const car of run.cars) car.makeGrowable();
    Object.assign(this.results.get(name), about);
    this.driven.set(name, run);
  }
}
