// The other end of packing.py.

// Text -> Map of name -> Float64Array.
async function decodeColumns(text) {
  const bytes = await inflate(text);
  const headLength = new DataView(bytes.buffer).getUint32(0, true);
  let start = 4 + headLength;
  const columns = JSON.parse(new TextDecoder().decode(bytes.subarray(4, start)));
  const decoded = new Map();
  for (const column of columns) {
    const end = start + column.count * column.width;
    decoded.set(column.name, decodeColumn(column, bytes.subarray(start, end)));
    start = end;
  }
  return decoded;
}

async function decodeJson(text) {
  return JSON.parse(new TextDecoder().decode(await inflate(text)));
}

async function inflate(base64) {
  const packed = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function decodeColumn({ count, width, quantum, offset, stride, order }, bytes) {
  const whole = new Uint32Array(count);
  for (let plane = 0; plane < width; ++plane) {
    for (let index = 0; index < count; ++index) {
      whole[index] |= bytes[plane * count + index] << (8 * plane);
    }
  }
  const mask = width === 4 ? 0xffffffff : 2 ** (8 * width) - 1;
  for (let taken = 0; taken < order; ++taken) {
    for (let index = stride; index < count; ++index) {
      whole[index] = (whole[index] + whole[index - stride]) & mask;
    }
  }
  return Float64Array.from(whole, (value) => (value + offset) * quantum);
}
