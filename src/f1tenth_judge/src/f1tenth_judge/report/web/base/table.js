// Tables, whose rows can be put in order by any column.

import { element } from "./elements.js";

// Columns are titles; rows are {cells, kind, click}.
export function table(columns, rows) {
  return makeTable(columns.map((title) => element("th", { scope: "col" }, title)), columns, rows);
}

// The same; rows have `keys`, one per column: numbers or words to be ordered by, null where there is none.
export function sortableTable(columns, rows) {
  const heads = columns.map((title) => element("th", { scope: "col" }, title && element("button.sort", { type: "button" }, title)));
  const made = makeTable(heads, columns, rows);
  const order = rows.map(({ keys }, index) => ({ keys, row: made.tBodies[0].rows[index] }));
  heads.forEach((head, column) => head.firstChild?.addEventListener("click", () => {
    const descending = head.ariaSort === "ascending";
    for (const each of heads) each.ariaSort = null;
    head.ariaSort = descending ? "descending" : "ascending";
    const sorted = order.toSorted((one, other) => compare(one.keys[column], other.keys[column], descending ? -1 : 1));
    made.tBodies[0].append(...sorted.map(({ row }) => row));
  }));
  return made;
}

function makeTable(heads, columns, rows) {
  const body = rows.map(({ cells, kind = "", click }) =>
    element(kind ? `tr.${kind}` : "tr", { click }, ...cells.map((cell, index) =>
      element("td", { "data-label": columns[index] }, cell))));
  return element("table", {}, element("thead", {}, element("tr", {}, ...heads)), element("tbody", {}, ...body));
}

// What is not known comes last in both directions.
function compare(one, other, sign) {
  if (one === null || other === null) return Number(one === null) - Number(other === null);
  return sign * (typeof one === "number" ? one - other : one.localeCompare(other));
}
