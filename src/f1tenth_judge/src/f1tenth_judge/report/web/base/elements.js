// Building the page: element("a.link", {href: "#"}, "text", child, ...).

export function element(selector, attributes = {}, ...children) {
  const [tag, ...classes] = selector.split(".");
  const made = document.createElement(tag || "div");
  if (classes.length) made.className = classes.join(" ");
  for (const [name, value] of Object.entries(attributes)) setAttribute(made, name, value);
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

function setAttribute(target, name, value) {
  if (typeof value === "function") target.addEventListener(name, value);
  else if (value === true) target.setAttribute(name, "");
  else if (value !== false && value !== null && value !== undefined) target.setAttribute(name, value);
}

export function svgElement(tag, attributes) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}

// The colours of the style sheet, for canvases; asked anew when the scheme may have changed.
export function themeColours() {
  const style = getComputedStyle(document.documentElement);
  const colour = (name) => style.getPropertyValue(`--${name}`).trim();
  return {
    road: colour("road"),
    wall: colour("wall"),
    grid: colour("line"),
    text: colour("text"),
    muted: colour("muted"),
    surface: colour("surface"),
    scan: colour("scan"),
    scanEdge: colour("scan-edge"),
    globalPlan: colour("global-plan"),
    localPlan: colour("local-plan"),
    bad: colour("bad"),
    goal: colour("goal"),
    model: colour("model"),
    drawing: colour("drawing"),
    ghost: colour("ghost"),
    cars: [1, 2, 3, 4].map((number) => colour(`car-${number}`)),
  };
}
