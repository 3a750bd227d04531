// Round numbers for axes.

const MOST_DIGITS = 4; // after the point
const WIDE = 1e5; // has no room beside a chart

// 1, 2 or 5 times a power of ten, not below a value.
export function niceStep(value) {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1e-300)));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= value * 0.999);
}

// The least and the greatest value of an axis on which all values have room, and the step between its rules.
export function niceRange(least, greatest) {
  const span = Math.max(greatest - least, Math.abs(greatest) * 1e-6, 1e-12);
  const step = niceStep(span / 3);
  const margin = (value) => (value === 0 ? 0 : 0.02 * span); // nothing is beyond a natural zero
  return { low: Math.floor((least - margin(least)) / step + 1e-9) * step, high: Math.ceil((greatest + margin(greatest)) / step - 1e-9) * step, step };
}

export function digitsOf(step) {
  return Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
}

// A place on an axis whose rules are a step apart.
export function axisLabel(value, step) {
  const digits = digitsOf(step);
  const isLong = Math.abs(value) >= WIDE || digits > MOST_DIGITS;
  const text = isLong && value !== 0 ? value.toExponential(1) : value.toFixed(isLong ? 0 : digits);
  return text.replaceAll("-", "−").replace(/^−(0\.?0*)$/, "$1");
}
