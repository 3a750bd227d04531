// A run's data as the views need it. The columns' names are those of replay_columns.py.

// The F1/10 car: its ends seen from base_footprint, wheelbase and track, m.
const F1TENTH = [-0.1186, 0.4615, -0.155, 0.155, 0.33, 0.2];
const QUANTITIES = ["x", "y", "yaw", "speed", "clearance", "steering", "gap"];

class Run {
  constructor(columns, world = new Map()) {
    this.columns = new Map([...columns, ...world]);
    this.cars = this.names("cars").map((name) => new CarTrack(name, columns));
    this.end = Math.max(0, ...this.cars.map((car) => car.end));
    this.walls = this.shape("walls");
    this.models = this.names("models").map((name) => this.model(name));
    this.goals = this.names("goals").map((car) => ({ car, poses: this.poses(`goals/${car}`) }));
    this.lidars = this.cars.filter(({ name }) => columns.has(`lidars/${name}`)).map((car) => new Lidar(car, columns.get(`lidars/${car.name}`)));
    this.still = obstaclesOf(this.walls);
    this.globalPlans = this.plans("global");
    this.localPlans = this.plans("local");
  }

  // The distinct second parts of names: "cars/robot1/x" -> "robot1".
  names(group) {
    const found = [...this.columns.keys()].filter((key) => key.startsWith(`${group}/`));
    const inner = found.map((key) => key.slice(group.length + 1, key.indexOf("/", group.length + 1)));
    return group === "walls" ? [] : [...new Set(inner)];
  }

  column(name) {
    return this.columns.get(name) ?? new Float64Array();
  }

  poses(name) {
    const [x, y, yaw] = ["x", "y", "yaw"].map((quantity) => this.column(`${name}/${quantity}`));
    return Array.from(x, (value, index) => ({ x: value, y: y[index], yaw: yaw[index] }));
  }

  lines(name) {
    const [x, y] = [this.column(`${name}/x`), this.column(`${name}/y`)];
    let start = 0;
    return Array.from(this.column(`${name}/length`), (length) => {
      const line = { x: x.subarray(start, start + length), y: y.subarray(start, start + length) };
      start += length;
      return line;
    });
  }

  shape(name) {
    const flat = this.column(`${name}/circles`);
    const circles = [];
    for (let index = 0; index + 2 < flat.length; index += 3) {
      circles.push({ x: flat[index], y: flat[index + 1], radius: flat[index + 2] });
    }
    return { outlines: this.lines(`${name}/outlines`), circles };
  }

  model(name) {
    return {
      name,
      time: this.column(`models/${name}/time`),
      poses: this.poses(`models/${name}`),
      shape: this.shape(`models/${name}`),
    };
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

  plans(kind) {
    return this.names(`plans/${kind}`).map((car) => ({
      car,
      time: this.column(`plans/${kind}/${car}/time`),
      lines: this.lines(`plans/${kind}/${car}`),
    }));
  }
}

class CarTrack {
  constructor(name, columns) {
    this.name = name;
    for (const quantity of ["time", ...QUANTITIES]) {
      this[quantity] = columns.get(`cars/${name}/${quantity}`) ?? new Float64Array();
    }
    this.end = this.time.length ? this.time[this.time.length - 1] : 0;
    const [rear, front, right, left, wheelbase, track] = columns.get(`bodies/${name}`) ?? F1TENTH;
    this.body = { rear, front, right, left, wheelbase, track };
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
    const state = {};
    for (const quantity of QUANTITIES) {
      const values = this[quantity];
      state[quantity] = values[before] + part * (values[after] - values[before]);
    }
    return state;
  }
}

// How many of the ascending times are not after a time.
function indexAfter(times, time) {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time + 1e-6) low = middle + 1;
    else high = middle;
  }
  return low;
}

function transform(pose, point) {
  const [cosine, sine] = [Math.cos(pose.yaw), Math.sin(pose.yaw)];
  return { x: pose.x + cosine * point.x - sine * point.y, y: pose.y + sine * point.x + cosine * point.y };
}
