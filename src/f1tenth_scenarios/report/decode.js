// The other end of packing.py: {columns, data} -> Map of name -> Float64Array.

async function decodeColumns(packed) {
  const bytes = await inflate(packed.data);
  const decoded = new Map();
  let start = 0;
  for (const column of packed.columns) {
    const end = start + column.count * column.width;
    decoded.set(column.name, decodeColumn(column, bytes.subarray(start, end)));
    start = end;
  }
  return decoded;
}

async function inflate(base64) {
  const packed = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function decodeColumn({ count, width, quantum, offset, stride }, bytes) {
  const whole = new Uint32Array(count);
  for (let plane = 0; plane < width; ++plane) {
    for (let index = 0; index < count; ++index) {
      whole[index] |= bytes[plane * count + index] << (8 * plane);
    }
  }
  const mask = width === 4 ? 0xffffffff : 2 ** (8 * width) - 1;
  for (let index = stride; index < count; ++index) {
    whole[index] = (whole[index] + whole[index - stride]) & mask;
  }
  return Float64Array.from(whole, (value) => (value + offset) * quantum);
}
