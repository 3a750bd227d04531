// What moves in the top view; `view` is a View with the `states` of its cars.

import { indexAfter } from "../data/geometry.js";

const TRAIL = 1.5; // s of the path behind a car that is drawn bold

export function drawMoving(painter, view) {
  const { run, shown, colours, states, time, isRace } = view;
  if (shown.scan) drawScans(painter, view);
  for (const model of run.models) {
    const pose = run.modelPose(model, time);
    if (pose) painter.inFrame(pose, () => painter.shape(model.shape, colours.model));
  }
  if (shown.plans) drawPlans(painter, view);
  if (shown.drawings) drawDrawings(painter, view);
  if (shown.ghost && view.ghost) drawGhosts(painter, view);
  const colourOf = (index) => colours.cars[index % 4];
  run.cars.forEach((car, index) => {
    const last = indexAfter(car.time, time);
    painter.strokeLine(car, isRace ? colourOf(index) : colours.text, 3.5, indexAfter(car.time, time - TRAIL), last);
  });
  run.cars.forEach((car, index) => {
    const { x, y } = states[index];
    painter.car(states[index], car.body, colourOf(index));
    if (isRace) painter.label(x, y, car.name, colours.text, 11, index % 2 ? 22 : -22, colours.road); // beside a neighbour on the grid
  });
}

function drawScans(painter, { run, time }) {
  for (const lidar of run.lidars) {
    painter.scan(lidar.points(lidar.car.at(time), run.obstacles(lidar.car, time)));
  }
}

function drawPlans(painter, { run, colours, time: now }) {
  const kinds = [[run.globalPlans, colours.globalPlan, 2], [run.localPlans, colours.localPlan, 3]];
  for (const [plans, colour, pixels] of kinds) {
    for (const { time, lines } of plans) {
      const index = indexAfter(time, now) - 1;
      if (index >= 0) painter.strokeLine(lines[index], colour, pixels);
    }
  }
}

function drawDrawings(painter, { run, time: now }) {
  for (const { time, frames } of run.drawings) {
    const index = indexAfter(time, now) - 1;
    if (index >= 0) frames[index].forEach((drawing) => painter.drawing(drawing));
  }
}

function drawGhosts(painter, { run, ghost, colours, time }) {
  const bodies = new Map(run.cars.map(({ name, body }) => [name, body]));
  for (const car of ghost.cars) {
    painter.context.setLineDash([4 / painter.scale, 4 / painter.scale]);
    painter.strokeLine(car, colours.ghost, 1.5);
    painter.context.setLineDash([]);
    painter.car(car.at(time), bodies.get(car.name) ?? car.body, colours.ghost, 0.7);
  }
}
