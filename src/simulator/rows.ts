/** The rows of the simulator: two buffers with one row per particle each. layout.ts has their layout. */
import { ATTRIBUTE_BITS, ATTRIBUTE_WORDS, TEMPERATURE_MAX } from './layout.ts';

/** Rows of a view. The arrays of a simulator are views on WASM memory: use or copy them before its next call. */
export interface Rows {
  /** Number of rows in each array, after culling. */
  readonly count: number;
  /** Number of rows whose puffs are not eroded. They come first. */
  readonly whole: number;
  /** {@link PLACE_FLOATS} per row. */
  readonly place: Float32Array;
  /** {@link ATTRIBUTE_WORDS} per row. */
  readonly attributes: Uint32Array;
}

type Bits = (typeof ATTRIBUTE_BITS)[keyof typeof ATTRIBUTE_BITS];

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

/** One field of the attributes of row `index`. */
export function readBits(attributes: Uint32Array, index: number, { word, shift, max }: Bits): number {
  return (attributes[ATTRIBUTE_WORDS * index + word] >>> shift) & max;
}

/** Unpacks the attributes of row `index`. For tests and tools; the shaders have their own unpacking. */
export function readAttributes(attributes: Uint32Array, index: number): RowAttributes {
  const { roll, age, variation, seed, temperature, tint } = ATTRIBUTE_BITS;
  const read = (bits: Bits) => readBits(attributes, index, bits);
  return {
    roll: read(roll) / (roll.max + 1),
    age: read(age) / age.max,
    variation: read(variation),
    seed: read(seed),
    temperature: (read(temperature) / temperature.max) * TEMPERATURE_MAX,
    tint: read(tint),
  };
}
