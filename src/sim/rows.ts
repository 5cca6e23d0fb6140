/**
 * Layout of the simulator's rows: two buffers with one row per particle each, 24 bytes per particle in total.
 *
 * place: four float32: world x, y, z in metres at the view's blend, and the radius in metres. attributes: two uint32.
 *   word 0: bits 0-15 roll as a fraction of a turn; bits 16-31 age as a fraction of the lifetime. In rows for the
 *   light, bits 16-31 are the end of the shadow, in 256ths of a radius behind the centre, 0xffff for no end.
 *   word 1: byte 0 variation; byte 1 seed; byte 2 temperature in steps of 4/255; byte 3 tint, 0 for none.
 *
 * The Rust code has the same constants. `tests/unit/sim/layout.test.ts` compares them with what the WASM reports.
 */
export const PLACE_FLOATS = 4;
export const ATTRIBUTE_WORDS = 2;
export const ROW_BYTES = 4 * (PLACE_FLOATS + ATTRIBUTE_WORDS);

/** Shadow end in word 0 of a row's attributes for an unbounded shadow. */
export const NO_END = 0xffff0000;

/** Two poses of a rigid: position and quaternion (x, y, z, w) at the previous step, then at the latest. */
export const RIGID_FLOATS = 14;
/** One pose: x, y, z in metres, then the unit quaternion x, y, z, w. */
export const POSE_FLOATS = 7;

/** Parameters that take a rigid's index refer to the scene's part n by this value plus n. */
export const FIRST_PART = 4096;

/** Temperature for the value 255 in byte 2 of word 1. */
export const TEMPERATURE_MAX = 4;

/** Rows of a view. The arrays of a simulator are views on WASM memory: use or copy them before its next call. */
export interface Rows {
  /** Number of rows in each array, after culling. */
  readonly count: number;
  /** {@link PLACE_FLOATS} per row. */
  readonly place: Float32Array;
  /** {@link ATTRIBUTE_WORDS} per row. */
  readonly attributes: Uint32Array;
}

/** The unpacked attributes of a row. */
export interface RowAttributes {
  /** Roll as a fraction of a turn, 0 to 1: about the view axis, or for lobes about an axis chosen by the seed. */
  roll: number;
  /** Age as a fraction of the lifetime, 0 to 1. */
  age: number;
  /** Index of the puff variation, 0 to 255. */
  variation: number;
  /** Random number of the particle, 0 to 255. */
  seed: number;
  /** 0 to {@link TEMPERATURE_MAX}. */
  temperature: number;
  /** 1 to 15 after contact with a tinting collider, otherwise 0. */
  tint: number;
}

/** Unpacks the attributes of row `index`. For tests and tools; the shaders have their own unpacking. */
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
