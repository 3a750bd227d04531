// Round numbers for axes.

// 1, 2 or 5 times a power of ten, not below a value.
export function niceStep(value) {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1e-6)));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= value * 0.999);
}

// The least and the greatest value of an axis on which all values have room, and the step between its rules.
export function niceRange(least, greatest) {
  const step = niceStep((greatest - least) / 3);
  return { low: Math.floor((least + 1e-9 * step) / step) * step, high: Math.ceil((greatest * 1.02) / step) * step, step };
}
