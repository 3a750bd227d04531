// The paths of a run as a small picture.

import { svgElement } from "../base/elements.js";

// `paths`: of each car, [x, y] in m; the size in px.
export function pathPicture(paths, { width, height, margin }) {
  const points = paths.flat();
  const picture = svgElement("svg", { viewBox: `0 0 ${width} ${height}`, width, height, class: "thumbnail", "aria-hidden": "true" });
  if (!points.length) return picture;
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  const [left, top] = [Math.min(...xs), Math.max(...ys)];
  const [spanX, spanY] = [Math.max(...xs) - left, top - Math.min(...ys)];
  const scale = Math.min((width - 2 * margin) / Math.max(spanX, 1), (height - 2 * margin) / Math.max(spanY, 1));
  const shift = [(width - scale * spanX) / 2, (height - scale * spanY) / 2];
  paths.forEach((path, index) => {
    const place = ([x, y]) => `${(shift[0] + scale * (x - left)).toFixed(1)},${(shift[1] + scale * (top - y)).toFixed(1)}`;
    picture.append(svgElement("polyline", { points: path.map(place).join(" "), class: `car-${(index % 4) + 1}` }));
  });
  return picture;
}
