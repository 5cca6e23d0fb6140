/**
 * Reads and writes the particles of a simulator through its saved state, the only way to place given particles.
 * Relevant parts of the format in sim-wasm/sim/src/simulator/snapshot.rs: an envelope with a checksum, sections with a
 * name of four letters and a length, and the content of the particle section.
 */

/** The columns of particle state in saved order. */
const FLOAT_COLUMNS = [
  'x',
  'y',
  'z',
  'px',
  'py',
  'pz',
  'sx',
  'sy',
  'sz',
  'age',
  'lifetime',
  'size',
  'temperature',
] as const;

/** Struct of arrays; units as in sim-wasm/sim/src/particles/mod.rs. */
export type Particles = Record<(typeof FLOAT_COLUMNS)[number], Float32Array> & { attributes: Uint32Array };

/** The part of a simulator that this file uses. */
interface Saving {
  save(): Uint8Array;
}

/** Offset of the checksum, and start of the bytes that it covers. */
const CHECKSUM = 8;
const BODY = 16;
const SECTION_HEAD = 8;
const PARTICLES = 'part';
const PARTICLE = 4 * (FLOAT_COLUMNS.length + 1);

export function emptyParticles(count: number): Particles {
  const columns = FLOAT_COLUMNS.map((name) => [name, new Float32Array(count)]);
  return { ...Object.fromEntries(columns), attributes: new Uint32Array(count) } as Particles;
}

/** Copies of the living particles. */
export function readParticles(simulator: Saving): Particles {
  const saved = simulator.save();
  const { content, end } = findSection(saved, PARTICLES);
  const count = viewOf(saved).getUint32(content, true);
  const words = saved.slice(content + 4, end).buffer;
  const columns = FLOAT_COLUMNS.map((name, index) => [name, new Float32Array(words, 4 * count * index, count)]);
  const attributes = new Uint32Array(words, 4 * count * FLOAT_COLUMNS.length, count);
  return { ...Object.fromEntries(columns), attributes } as Particles;
}

/** The simulator's state with other particles, for restore. */
export function withParticles(simulator: Saving, particles: Particles): Uint8Array {
  const saved = simulator.save();
  const { content, end } = findSection(saved, PARTICLES);
  const count = particles.x.length;
  const length = 4 + PARTICLE * count + 4;
  const bytes = new Uint8Array(content + length + saved.length - end);
  bytes.set(saved.subarray(0, content));
  bytes.set(saved.subarray(end), content + length);
  const view = viewOf(bytes);
  view.setUint32(content - 4, length, true);
  view.setUint32(content, count, true);
  const columns = [...FLOAT_COLUMNS.map((name) => particles[name]), particles.attributes];
  columns.forEach((column, index) =>
    bytes.set(new Uint8Array(column.buffer, column.byteOffset, 4 * count), content + 4 + 4 * count * index),
  );
  // No particles are held, so no columns follow.
  view.setUint32(content + length - 4, 0, true);
  writeChecksum(bytes);
  return bytes;
}

/** Size of a section of the saved state, bytes. */
export function sectionLength(simulator: Saving, name: string): number {
  const { content, end } = findSection(simulator.save(), name);
  return end - content;
}

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

/** Start of a section's content, and its end. */
function findSection(saved: Uint8Array, name: string): { content: number; end: number } {
  const view = viewOf(saved);
  for (let head = BODY; head < saved.length;) {
    const content = head + SECTION_HEAD;
    const end = content + view.getUint32(head + 4, true);
    if (String.fromCharCode(...saved.subarray(head, head + 4)) === name) return { content, end };
    head = end;
  }
  throw new Error(`The saved state has no section ${name}.`);
}

/** FNV-1a over words as in sim-wasm/sim/src/math/hash.rs, in two halves of 32 bits. */
function writeChecksum(bytes: Uint8Array): void {
  const view = viewOf(bytes);
  let high = 0xcbf29ce4;
  let low = 0x84222325;
  const add = (word: number) => {
    low ^= word;
    const product = (low >>> 0) * 0x1b3;
    high = Math.imul(high, 0x1b3) + Math.floor(product / 2 ** 32) + (low << 8);
    low = product ^ high;
  };
  const end = BODY + ((bytes.length - BODY) & ~3);
  for (let offset = BODY; offset < end; offset += 4) add(view.getUint32(offset, true));
  add(bytes.length - end);
  add(0);
  for (let offset = end; offset < bytes.length; offset++) add(bytes[offset]);
  view.setUint32(CHECKSUM, low, true);
  view.setUint32(CHECKSUM + 4, high, true);
}
