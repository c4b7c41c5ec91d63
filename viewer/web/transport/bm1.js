// The binary answers of the server, "BM1": a length, a header in JSON, and arrays behind it.

const TYPES = { float32: Float32Array, uint32: Uint32Array, uint8: Uint8Array };

/** Read an answer; the arrays are views into the buffer, since bodies are large. */
export function readBM1(buffer) {
  const length = new DataView(buffer).getUint32(0, true);
  const text = new TextDecoder().decode(new Uint8Array(buffer, 4, length));
  const header = JSON.parse(text);
  const arrays = {};
  for (const [name, { offset, shape, dtype }] of Object.entries(header.arrays ?? {})) {
    const count = shape.reduce((product, size) => product * size, 1);
    const data = new TYPES[dtype](buffer, 4 + length + offset, count);
    arrays[name] = { data, shape };
  }
  return { header, arrays };
}

/** Decode what an exported page holds as text. */
export function decodeBase64(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < characters.length; i++) bytes[i] = characters.charCodeAt(i);
  return bytes.buffer;
}

/** What an exported page holds is packed as a gzip file, since it is mailed. */
export async function unpacked(buffer) {
  const stream = new Blob([buffer]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

/** An array without rows, for answers that leave one out. */
export const NO_ARRAY = { data: new Float32Array(0), shape: [0, 0, 3] };
