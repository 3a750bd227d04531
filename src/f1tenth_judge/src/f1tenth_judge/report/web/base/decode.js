// The other end of packing.py.

/** @param {string} text */
export function unpack(text) {
  const packed = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).json();
}

// The same with the columns in it, which begin with a number, as Float64Array.
export function decodeColumns(content) {
  if (typeof content !== "object") return content;
  if (!Array.isArray(content)) {
    return Object.fromEntries(Object.entries(content).map(([name, each]) => [name, decodeColumns(each)]));
  }
  return typeof content[0] === "number" ? decodeColumn(content) : content.map(decodeColumns);
}

function decodeColumn(packed) {
  const [quantum, ...changes] = packed;
  let [value, step] = [0, 0];
  return Float64Array.from(changes, (change) => {
    step += change;
    value += step;
    return value * quantum;
  });
}
