// A run that goes on: its data comes over Server-Sent Events, as feed.py says it.

import { decodeColumns, unpack } from "../base/decode.js";
import { Run } from "./run.js";

const COLUMNS = ["time", "x", "y", "yaw", "speed", "steering", "clearance"]; // of a row

export class LiveRun {
  // `onRun(run)` gets a new run whenever the simulation begins, `onNews(events)` whenever it has grown.
  constructor(onRun, onNews, onEnd) {
    this.onRun = onRun;
    this.onNews = onNews;
    this.source = new EventSource("/events");
    this.listen("scene", (scene) => { this.scene = scene; });
    this.listen("news", (news) => this.take(news));
    this.listen("end", (end) => {
      this.source.close();
      onEnd(end);
    });
  }

  // One after the other, although a scene takes time to be unpacked.
  listen(kind, act) {
    this.source.addEventListener(kind, ({ data }) => {
      this.last = Promise.resolve(this.last).then(() => act(JSON.parse(data)));
    });
  }

  async take({ begins, cars, events }) {
    if (begins) {
      const [columns, world] = await Promise.all([unpack(this.scene.run), unpack(this.scene.world)]);
      columns.cars = Object.fromEntries(Object.keys(cars).map((name) => [name, {}]));
      this.run = new Run(decodeColumns(columns), decodeColumns(world));
      for (const car of this.run.cars) car.makeGrowable();
    }
    for (const car of this.run.cars) car.grow(cars[car.name] ?? [], COLUMNS);
    this.run.end = Math.max(...this.run.cars.map((car) => car.end));
    if (begins) this.onRun(this.run);
    this.onNews(events);
  }

  close() {
    this.source.close();
  }
}
