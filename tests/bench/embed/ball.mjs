/** A ball as a binary glTF file: a minimal model for model-viewer. */

const [ACROSS, DOWN] = [32, 16];
const [ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER, FLOAT, UNSIGNED_SHORT] = [34962, 34963, 5126, 5123];
const [MAGIC, JSON_CHUNK, BINARY_CHUNK] = [0x46546c67, 0x4e4f534a, 0x004e4942];

export const TRIANGLES = 2 * ACROSS * DOWN;

/** @returns {Buffer} */
export function ball() {
  const points = grid(ACROSS + 1, DOWN + 1).flatMap(([column, row]) => pointAt(column / ACROSS, row / DOWN));
  const corners = grid(ACROSS, DOWN).flatMap(([column, row]) => {
    const first = row * (ACROSS + 1) + column;
    const below = first + ACROSS + 1;
    return [first, below, first + 1, first + 1, below, below + 1];
  });
  const places = Buffer.from(new Float32Array(points).buffer);
  const order = Buffer.from(new Uint16Array(corners).buffer);
  return packed(describe(places.length, order.length), Buffer.concat([places, order]));
}

/** @param {number} columns @param {number} rows @returns {[number, number][]} */
function grid(columns, rows) {
  return Array.from({ length: columns * rows }, (_, index) => [index % columns, Math.floor(index / columns)]);
}

/**
 * On the unit sphere.
 * @param {number} around 0 to 1
 * @param {number} down 0 to 1
 */
function pointAt(around, down) {
  const [angle, fall] = [2 * Math.PI * around, Math.PI * down];
  return [Math.sin(fall) * Math.cos(angle), Math.cos(fall), -Math.sin(fall) * Math.sin(angle)];
}

/** @param {number} places bytes @param {number} order bytes */
function describe(places, order) {
  const unit = { min: [-1, -1, -1], max: [1, 1, 1] };
  const vectors = { bufferView: 0, componentType: FLOAT, count: places / 12, type: 'VEC3', ...unit };
  return {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    // The normals of a unit sphere are its positions.
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 0 }, indices: 1 }] }],
    accessors: [vectors, { bufferView: 1, componentType: UNSIGNED_SHORT, count: order / 2, type: 'SCALAR' }],
    bufferViews: [
      { buffer: 0, byteLength: places, target: ARRAY_BUFFER },
      { buffer: 0, byteOffset: places, byteLength: order, target: ELEMENT_ARRAY_BUFFER },
    ],
    buffers: [{ byteLength: places + order }],
  };
}

/**
 * @param {object} description
 * @param {Buffer} binary length is a multiple of 4
 */
function packed(description, binary) {
  const text = JSON.stringify(description);
  const json = Buffer.from(text.padEnd(Math.ceil(text.length / 4) * 4));
  const length = 12 + 8 + json.length + 8 + binary.length;
  return Buffer.concat([
    words(MAGIC, 2, length),
    words(json.length, JSON_CHUNK),
    json,
    words(binary.length, BINARY_CHUNK),
    binary,
  ]);
}

/** @param {number[]} values */
function words(...values) {
  return Buffer.from(new Uint32Array(values).buffer);
}
