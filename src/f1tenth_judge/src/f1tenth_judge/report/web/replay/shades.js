// The colours of a path: by speed, or by the time that it gains and loses.

import { deltaShades } from "../compare/delta.js";

export const SPEED_COLOURS = ["#4f6bed", "#7a5be0", "#a94fc6", "#d2489b", "#ec5a6d", "#f57c42", "#f5a524"];
export const DELTA_COLOURS = ["#0f9d6b", "#5cbf95", "#9db8ad", "#a3a9b5", "#c9a9a0", "#e8806a", "#d92d20"];

// A shade for each moment of a car, and the colours that they stand for.
export function shadesOf(car, fastest) {
  if (car.delta.length) return { shades: deltaShades(car, car.delta, DELTA_COLOURS.length), colours: DELTA_COLOURS };
  return { shades: Array.from(car.speed, (speed) => speedShade(speed, fastest)), colours: SPEED_COLOURS };
}

function speedShade(speed, fastest) {
  const part = Math.abs(speed) / Math.max(fastest, 0.1);
  return Math.min(Math.floor(part * SPEED_COLOURS.length), SPEED_COLOURS.length - 1);
}
