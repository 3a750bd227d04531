// A run's data as the views need it. The columns' names are those of replay_columns.py.

import { indexAfter, obstaclesOf, rowsOf, shapeOf, wrapped } from "./geometry.js";
import { Lidar } from "./lidar.js";

// The F1/10 car: its ends seen from base_footprint, wheelbase and track, m.
const F1TENTH = [-0.1186, 0.4615, -0.155, 0.155, 0.33, 0.2];
const MOST = 20000; // moments of a car whose data is coming: then the older half loses every second one
const MOST_FRAMES = 1000; // of a topic, of a run that goes on: the latest
const QUANTITIES = ["x", "y", "yaw", "speed", "clearance", "steering", "gap", "acceleration", "way", "delta"];

// m/s^2 along the car, over a stretch of moments in which the rounding of the speed does not matter.
function accelerationOf({ time, speed }) {
  const stretch = 2; // moments, before and after
  return Float64Array.from(time, (_, index) => {
    const [from, to] = [Math.max(index - stretch, 0), Math.min(index + stretch, time.length - 1)];
    return to > from ? (speed[to] - speed[from]) / (time[to] - time[from]) : 0;
  });
}

class CarTrack {
  constructor(name, columns, [rear, front, right, left, wheelbase, track] = F1TENTH) {
    this.name = name;
    this.time = columns.time ?? new Float64Array();
    this.speed = columns.speed ?? new Float64Array();
    for (const quantity of QUANTITIES) this[quantity] = columns[quantity] ?? new Float64Array();
    this.yaw = columns.yaw ?? new Float64Array();
    this.way = columns.way ?? new Float64Array();
    // Numbers that the planner published, under the names of their topics.
    this.topics = Object.keys(columns).filter((column) => column.startsWith("/"));
    for (const topic of this.topics) this[topic] = columns[topic];
    this.acceleration = accelerationOf(this);
    this.end = this.time.length ? this.time[this.time.length - 1] : 0;
    this.body = { rear, front, right, left, wheelbase, track };
  }

  // For a car whose data is still coming.
  makeGrowable() {
    for (const quantity of ["time", ...QUANTITIES]) this[quantity] = [];
  }

  // `rows` have the values of the columns of these names; angles go on where they were.
  grow(rows, names) {
    for (const row of rows) {
      const before = this.yaw.at(-1);
      names.forEach((name, column) => this[name].push(row[column] ?? NaN));
      if (before !== undefined) this.yaw[this.yaw.length - 1] = before + wrapped(this.yaw.at(-1) - before);
    }
    this.end = this.time.at(-1) ?? 0;
    if (this.time.length > MOST) for (const name of names) this[name] = this[name].filter((_, index) => index % 2 === 0 || index > MOST / 2);
  }

  get shape() {
    const { rear, front, right, left } = this.body;
    return { outlines: [{ x: [rear, front, front, rear], y: [right, right, left, left] }], circles: [] };
  }

  // The state at a time (s), between two periods by proportion.
  at(time) {
    const after = Math.min(indexAfter(this.time, time), this.time.length - 1);
    const before = Math.max(after - 1, 0);
    const span = this.time[after] - this.time[before];
    const part = span > 0 ? Math.min(Math.max((time - this.time[before]) / span, 0), 1) : 0;
    /** @type {Record<string, number>} */
    const state = {};
    for (const quantity of [...QUANTITIES, ...this.topics]) {
      const values = this[quantity];
      state[quantity] = values[before] + part * (values[after] - values[before]);
    }
    return state;
  }
}

function drawingOf({ colour, lines, dots, places, texts }) {
  return { colour, lines, dots: rowsOf(dots), texts: rowsOf(places).map((place, index) => ({ ...place, text: texts[index] })) };
}

export class Run {
  // `world` is that of the walls; who is only compared with another run needs none.
  constructor({ cars, goals, lidars, bodies, global_plans: globalPlans, local_plans: localPlans, models, road, drawings, pictures }, world) {
    this.cars = Object.entries(cars).map(([name, columns]) => new CarTrack(name, columns, bodies[name]));
    this.end = Math.max(0, ...this.cars.map((car) => car.end));
    this.goals = goals.map(rowsOf);
    this.lidars = this.cars.filter(({ name }) => lidars[name]).map((car) => new Lidar(car, lidars[car.name]));
    this.models = models.map(({ time, poses, shape }) => ({ time, poses: rowsOf(poses), shape: shapeOf(shape) }));
    this.road = road;
    this.pictures = Object.entries(pictures).map(([topic, each]) => ({ topic, ...each }));
    this.drawings = Object.entries(drawings).map(([topic, { time, frames }]) => ({ topic, time, frames: frames.map((frame) => frame.map(drawingOf)) }));
    this.globalPlans = globalPlans;
    this.localPlans = localPlans;
    if (world) {
      this.walls = shapeOf(world.walls);
      this.still = obstaclesOf(this.walls);
    }
  }

  // Something is drawn while the run goes on; at the time of the last drawing of a topic it replaces that.
  draw(topic, time, frame) {
    let drawing = this.drawings.find((each) => each.topic === topic);
    if (!drawing && !frame.length) return;
    if (!drawing) this.drawings.push(drawing = { topic, time: [], frames: [] });
    if (drawing.time.at(-1) === time) for (const list of [drawing.time, drawing.frames]) list.pop();
    drawing.time.push(time);
    drawing.frames.push(frame.map(drawingOf));
    if (drawing.time.length > MOST_FRAMES) for (const list of [drawing.time, drawing.frames]) list.shift();
  }

  modelPose(model, time) {
    return model.poses[Math.max(indexAfter(model.time, time) - 1, 0)];
  }

  // What the lidar of a car meets at a time.
  obstacles(own, time) {
    const models = this.models.filter((model) => this.modelPose(model, time)).map((model) => obstaclesOf(model.shape, this.modelPose(model, time)));
    const others = this.cars.filter((car) => car !== own).map((car) => obstaclesOf(car.shape, car.at(time)));
    const all = [this.still, ...models, ...others];
    return { segments: all.flatMap(({ segments }) => segments), circles: all.flatMap(({ circles }) => circles) };
  }
}
