/**
 * How the simulator writes a row: two buffers side by side, one row a particle in each, 24 bytes together.
 *
 * place: four float32: world x, y, z in metres at the view's blend, and the radius in metres.
 * attributes: two uint32.
 *   word 0: bits 0-15 roll as a fraction of a turn; bits 16-31 age as a fraction of the lifetime; in rows for the light, where the
 *   shadow may end, in 256ths of a radius behind the centre, 0xffff for nowhere.
 *   word 1: byte 0 variation; byte 1 seed; byte 2 temperature in steps of 4/255; byte 3 tint, 0 for none.
 *
 * The same numbers stand in Rust; `tests/unit/simLayout.test.ts` compares them with what the WASM reports.
 */
export const PLACE_FLOATS = 4;
export const ATTRIBUTE_WORDS = 2;
export const ROW_BYTES = 4 * (PLACE_FLOATS + ATTRIBUTE_WORDS);

/** The end, in the first word of a row's attributes, of a shadow that goes on for ever. */
export const NO_END = 0xffff0000;

/** A rigid's poses: position and quaternion (x, y, z, w) one step earlier, then the same now. */
export const RIGID_FLOATS = 14;
/** One pose: x, y, z in metres, then the unit quaternion x, y, z, w. */
export const POSE_FLOATS = 7;

/** Where the number of a rigid is expected, the scene's parts follow from this number on. */
export const FIRST_PART = 4096;

/** Temperature that byte 2 of the second word of a row's attributes stands for when it is 255. */
export const TEMPERATURE_MAX = 4;

/** What {@link Simulator.arrange} hands out. The arrays lie in the simulator's memory: use or copy before its next call. */
export interface Rows {
  /** Rows kept, and so the rows in each array. */
  readonly count: number;
  /** {@link PLACE_FLOATS} a row. */
  readonly place: Float32Array;
  /** {@link ATTRIBUTE_WORDS} a row. */
  readonly attributes: Uint32Array;
}

/** A row's attributes, unpacked. */
export interface RowAttributes {
  /** Roll, fraction of a turn, 0 to 1: about the view axis, or of a puff of lobes about an axis that the seed chooses. */
  roll: number;
  /** Age as a fraction of the lifetime, 0 to 1. */
  age: number;
  /** Which variation of the puff; 0 to 255. */
  variation: number;
  /** A number of the particle's own, 0 to 255. */
  seed: number;
  /** 0 to {@link TEMPERATURE_MAX}. */
  temperature: number;
  /** 1 to 15 for what touched a collider that tints, else 0. */
  tint: number;
}

/** Unpacks row `index` of an array of attributes; for tests and tools, the shaders do the same for themselves. */
export function readAttributes(attributes: Uint32Array, index: number): RowAttributes {
  const motion = attributes[ATTRIBUTE_WORDS * index];
  const kind = attributes[ATTRIBUTE_WORDS * index + 1];
  return {
    roll: (motion & 0xffff) / 0x10000,
    age: (motion >>> 16) / 0xffff,
    variation: kind & 0xff,
    seed: (kind >>> 8) & 0xff,
    temperature: (((kind >>> 16) & 0xff) / 0xff) * TEMPERATURE_MAX,
    tint: kind >>> 24,
  };
}
