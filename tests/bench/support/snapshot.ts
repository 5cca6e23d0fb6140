/**
 * Particles in and out of a simulator by its saved state, because nothing else can place a given particle. Only two
 * things of the layout in sim-wasm/sim/src/snapshot.rs are known here: the checksum in the head, and that the living
 * particles, their number first and then column by column, are the end.
 */

/** The columns of particle state in the order in which they are saved. */
export const FLOAT_COLUMNS = [
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

/** Struct of arrays; units as in sim-wasm/sim/src/particles.rs. */
export type Particles = Record<(typeof FLOAT_COLUMNS)[number], Float32Array> & { look: Uint32Array };

/** What a simulator that has made no step yet remembers besides its particles, as far as the twin needs it. */
export interface Memory {
  seed: number;
  /** Metres by which the wind has carried the turbulence, and its phase in radians. */
  drift: [number, number, number];
  phase: number;
}

/** A simulator, as far as this file needs one. */
interface Saving {
  readonly alive: number;
  save(): Uint8Array;
}

/** Where the checksum stands, and where what it covers begins. */
const CHECKSUM = 8;
const BODY = 16;
const PARTICLE = 4 * (FLOAT_COLUMNS.length + 1);

export function emptyParticles(count: number): Particles {
  const columns = FLOAT_COLUMNS.map((name) => [name, new Float32Array(count)]);
  return { ...Object.fromEntries(columns), look: new Uint32Array(count) } as Particles;
}

/** The living particles, copied. */
export function readParticles(simulator: Saving): Particles {
  const saved = simulator.save();
  const count = simulator.alive;
  const words = saved.slice(particlesOffset(saved, count) + 4).buffer;
  const columns = FLOAT_COLUMNS.map((name, index) => [name, new Float32Array(words, 4 * count * index, count)]);
  const look = new Uint32Array(words, 4 * count * FLOAT_COLUMNS.length, count);
  return { ...Object.fromEntries(columns), look } as Particles;
}

/** The simulator's state with other particles, for restore. */
export function withParticles(simulator: Saving, particles: Particles): Uint8Array {
  const saved = simulator.save();
  const offset = particlesOffset(saved, simulator.alive);
  const count = particles.x.length;
  const bytes = new Uint8Array(offset + 4 + PARTICLE * count);
  bytes.set(saved.subarray(0, offset));
  viewOf(bytes).setUint32(offset, count, true);
  const columns = [...FLOAT_COLUMNS.map((name) => particles[name]), particles.look];
  columns.forEach((column, index) =>
    bytes.set(new Uint8Array(column.buffer, column.byteOffset, 4 * count), offset + 4 + 4 * count * index),
  );
  writeChecksum(bytes);
  return bytes;
}

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

/** Where the number of particles stands. */
function particlesOffset(saved: Uint8Array, alive: number): number {
  const offset = saved.length - PARTICLE * alive - 4;
  if (viewOf(saved).getUint32(offset, true) !== alive) {
    throw new Error('The particles are no longer the end of a saved state.');
  }
  return offset;
}

/** FNV-1a over words as in sim-wasm/sim/src/hash.rs, in two halves of 32 bits. */
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
