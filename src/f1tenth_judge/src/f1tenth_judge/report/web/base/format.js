// Numbers and times as text.

export const NOTHING = "–";

export function formatNumber(value, digits, unit = "") {
  if (value === null || value === undefined || !Number.isFinite(value)) return NOTHING;
  const text = value.toFixed(digits).replace(/^-(?=[0.]*$)/, ""); // no −0.00
  return text.replace("-", "−") + (unit ? `\u202f${powers(unit)}` : "");
}

// Exponents as they are printed.
function powers(unit) {
  return unit.replace("^2", "²");
}

export function formatClock(seconds) {
  const minutes = Math.floor(seconds / 60);
  const rest = (seconds - 60 * minutes).toFixed(2).padStart(5, "0");
  return `${minutes}:${rest}`;
}

// Actual values and limits of criteria are numbers, words or nothing.
export function formatValue(value, unit = "") {
  if (value === null || value === undefined) return NOTHING;
  if (typeof value !== "number") return String(value);
  const text = Number.isInteger(value) ? String(value) : value.toFixed(3);
  const one = value === 1 ? unit.replace(/(?<=^[a-z]{2,})s$/, "") : unit; // 1 contact, 2 contacts
  return text.replace("-", "−") + (unit ? `\u202f${powers(one)}` : "");
}

export function formatDate(iso) {
  return new Date(iso).toLocaleString(undefined, { dateStyle: "medium", timeStyle: "short" });
}
