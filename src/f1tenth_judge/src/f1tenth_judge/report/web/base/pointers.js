// Mouse and fingers on a canvas: one pointer moves what is shown, two zoom it, a double click shows all.

const WHEEL_ZOOM = 0.0015; // of a zoom's logarithm, per pixel of a wheel

// `shown` has pan(dx, dy, pixel), zoom(factor, pixel) and fit(); it may have press(pixel), and takesWheel(event): without, it always does.
export function listenToPointers(canvas, shown) {
  const pointers = new Map();
  const place = (event) => ({ x: event.offsetX, y: event.offsetY });
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, place(event));
    if (pointers.size === 1) shown.press?.(place(event));
  });
  canvas.addEventListener("pointermove", (event) => {
    if (pointers.has(event.pointerId)) drag(shown, pointers, event.pointerId, place(event));
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  }
  canvas.addEventListener("wheel", (event) => {
    if (shown.takesWheel?.(event) === false) return;
    event.preventDefault();
    if (Math.abs(event.deltaX) > Math.abs(event.deltaY)) shown.pan(-event.deltaX, 0, place(event));
    else shown.zoom(Math.exp(-event.deltaY * WHEEL_ZOOM), place(event));
  }, { passive: false });
  canvas.addEventListener("dblclick", () => shown.fit());
}

function drag(shown, pointers, id, now) {
  const before = pointers.get(id);
  const other = [...pointers].find(([key]) => key !== id)?.[1];
  pointers.set(id, now);
  if (!other) {
    shown.pan(now.x - before.x, now.y - before.y, now);
    return;
  }
  const distance = (point) => Math.hypot(point.x - other.x, point.y - other.y);
  shown.zoom(distance(now) / Math.max(distance(before), 1), other);
}
