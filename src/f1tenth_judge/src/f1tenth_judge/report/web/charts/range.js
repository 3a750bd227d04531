// From which value to which one a chart goes.

import { niceRange } from "./axis.js";

const LEAST_RANGE = 0.1; // of values that are all the same

// Nought and the limit are in the picture of a whole run; a part is shown as large as there is room.
export function rangeOf({ lines, axis, quantity, span, limit }) {
  const always = span.part ? [] : [0, limit ?? 0];
  let [low, high] = [Math.min(...always), Math.max(...always)];
  for (const { car } of lines) {
    const [places, values] = [car[axis], car[quantity]];
    for (let index = 0; index < values.length; ++index) {
      if (places[index] < span.from || places[index] > span.to) continue;
      if (values[index] < low) low = values[index];
      if (values[index] > high) high = values[index];
    }
  }
  if (low < high) return niceRange(low, high);
  const least = Number.isFinite(low) && low !== 0 ? low - LEAST_RANGE / 2 : 0;
  return niceRange(least, least + LEAST_RANGE);
}
