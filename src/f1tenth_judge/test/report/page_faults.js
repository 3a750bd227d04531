// Everything on the page that nobody should see, one line each.
const faults = [];
const say = (what, node) => faults.push(`${what}: <${node.tagName.toLowerCase()}.${node.className}> ${node.textContent.trim().slice(0, 60)}`);

const parse = (colour) => {
  const values = colour.match(/[\d.]+/g).map(Number);
  return colour.startsWith("color(") ? [...values.slice(0, 3).map((value) => 255 * value), values[3] ?? 1] : [...values.slice(0, 3), values[3] ?? 1];
};
const over = ([r, g, b, a], below) => [r, g, b].map((value, index) => a * value + (1 - a) * below[index]);
const background = (node) => {
  if (!node) return [255, 255, 255];
  return over(parse(getComputedStyle(node).backgroundColor), background(node.parentElement));
};
const luminance = (rgb) => {
  const [r, g, b] = rgb.map((value) => value / 255).map((value) => (value <= 0.03928 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};

// WCAG 2.1, 1.4.3: 4.5, and 3 for large text.
function checkContrast(node) {
  const style = getComputedStyle(node);
  const below = background(node);
  const [one, other] = [luminance(over(parse(style.color), below)), luminance(below)];
  const ratio = (Math.max(one, other) + 0.05) / (Math.min(one, other) + 0.05);
  const size = parseFloat(style.fontSize);
  const least = size >= 24 || (size >= 18.66 && style.fontWeight >= 700) ? 3 : 4.5;
  if (ratio < least) say(`contrast ${ratio.toFixed(2)}`, node);
}

const walker = document.createTreeWalker(document.getElementById("page"), NodeFilter.SHOW_TEXT);
while (walker.nextNode()) {
  const node = walker.currentNode.parentElement;
  if (!walker.currentNode.textContent.trim() || !node.checkVisibility()) continue;
  if (/\[object|undefined|NaN/.test(walker.currentNode.textContent)) say("no text", node);
  checkContrast(node);
}
for (const node of document.querySelectorAll("button, a, input, select, canvas")) {
  if (node.checkVisibility() && !(node.textContent.trim() || node.ariaLabel || node.title)) say("no name", node);
}
const width = document.documentElement.clientWidth;
if (document.documentElement.scrollWidth > width) {
  for (const node of document.querySelectorAll("main *")) {
    if (node.getBoundingClientRect().right > width + 1) say("sticks out", node);
  }
}
for (const card of document.querySelectorAll(".card")) {
  const { left, right } = card.getBoundingClientRect();
  for (const node of card.querySelectorAll("*")) {
    const box = node.getBoundingClientRect();
    if (node.checkVisibility() && box.width && (box.right > right + 1 || box.left < left - 1)) say("leaves its card", node);
  }
}
if (window.hacked) faults.push("a planner's text has run as a script");
return faults;
