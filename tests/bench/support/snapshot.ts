/**
 * Particles in and out of a simulator by its saved state, because nothing else can place a given particle. The layout
 * is that of sim-wasm/sim/src/snapshot.rs; another version of it is refused there and here.
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

/** What a simulator remembers besides its particles, as far as a step without emission needs it. */
export interface Memory {
  seed: number;
  /** Metres by which the wind has carried the turbulence, and its phase in radians. */
  drift: [number, number, number];
  phase: number;
}

const VERSION = 1;
const BODY = 16;
const SEED = 24;
const DRIFT = 164;
const PHASE = 188;
const PARAMETERS = 196;

export function emptyParticles(count: number): Particles {
  const columns = FLOAT_COLUMNS.map((name) => [name, new Float32Array(count)]);
  return { ...Object.fromEntries(columns), look: new Uint32Array(count) } as Particles;
}

/** The living particles of a saved state, copied. */
export function readParticles(saved: Uint8Array): Particles {
  const offset = particlesOffset(saved);
  const count = viewOf(saved).getUint32(offset, true);
  const words = saved.slice(offset + 4).buffer;
  const columns = FLOAT_COLUMNS.map((name, index) => [name, new Float32Array(words, 4 * count * index, count)]);
  const look = new Uint32Array(words, 4 * count * FLOAT_COLUMNS.length, count);
  return { ...Object.fromEntries(columns), look } as Particles;
}

export function readMemory(saved: Uint8Array): Memory {
  const view = viewOf(saved);
  const drift = (axis: number) => view.getFloat64(DRIFT + 8 * axis, true);
  return {
    seed: view.getUint32(SEED, true),
    drift: [drift(0), drift(1), drift(2)],
    phase: view.getFloat64(PHASE, true),
  };
}

/** The same saved state with other particles. */
export function withParticles(saved: Uint8Array, particles: Particles): Uint8Array {
  const offset = particlesOffset(saved);
  const count = particles.x.length;
  const bytes = new Uint8Array(offset + 4 + 4 * count * (FLOAT_COLUMNS.length + 1));
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

/** Where the number of particles stands: behind the parameters by key and the rigids. */
function particlesOffset(saved: Uint8Array): number {
  const view = viewOf(saved);
  const version = view.getUint32(4, true);
  if (version !== VERSION) throw new Error(`The saved state has version ${version}, the bench knows ${VERSION}.`);
  let offset = PARAMETERS + 4;
  for (let entries = view.getUint32(PARAMETERS, true); entries > 0; entries--) {
    offset += 4 + view.getUint32(offset, true) + 8;
  }
  return offset + 4 + view.getUint32(offset, true);
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
  view.setUint32(8, low, true);
  view.setUint32(12, high, true);
}
