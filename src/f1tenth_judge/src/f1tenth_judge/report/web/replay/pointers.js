// Mouse and fingers on a canvas: one pointer moves the view, two zoom it, a double click fits it.

export function listenToPointers(canvas, view) {
  const pointers = new Map();
  const place = (event) => ({ x: event.offsetX, y: event.offsetY });
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, place(event));
  });
  canvas.addEventListener("pointermove", (event) => {
    if (pointers.has(event.pointerId)) drag(view, pointers, event.pointerId, place(event));
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  }
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    view.zoom(Math.exp(-event.deltaY * 0.0015), place(event));
  }, { passive: false });
  canvas.addEventListener("dblclick", () => view.fit());
}

function drag(view, pointers, id, now) {
  const before = pointers.get(id);
  const other = [...pointers].find(([key]) => key !== id)?.[1];
  pointers.set(id, now);
  if (!other) {
    view.pan(now.x - before.x, now.y - before.y);
    return;
  }
  const distance = (point) => Math.hypot(point.x - other.x, point.y - other.y);
  view.zoom(distance(now) / Math.max(distance(before), 1), other);
}
