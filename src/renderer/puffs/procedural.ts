/** Procedural puff shapes from a seed and three knobs, deterministic in every engine. */
import { inUnitBall } from './lobes.ts';
import type { Lobe, PuffShape } from './shapes.ts';
import { normalized, spherePoint } from './vector.ts';
import { MAX_LOBES } from '../../base/constants.ts';

/** Shape knobs, each from 0 to 1. */
export interface PuffKnobs {
  /** How far lobes protrude from the main mass: 0 is nearly a ball, 1 a cluster of balls. */
  readonly lumpiness: number;
  /** How much the puff is flattened along its local y axis: 0 is as tall as wide, 1 is the flattest. */
  readonly flatness: number;
  /** Variation of the sizes and positions of the lobes. */
  readonly roughness: number;
}

/** Default knobs: a typical cartoon cloud with distinct lobes of different sizes. */
export const CARTOON_KNOBS: PuffKnobs = { lumpiness: 0.55, flatness: 0.1, roughness: 0.5 };

/** Fewer lobes look like separate balls. */
const MIN_LOBES = 5;

/**
 * Creates a main mass with `lobes - 1` lobes around it, alternately large and small.
 * @param lobes total number, 5..{@link MAX_LOBES}
 * @throws RangeError if a knob or `lobes` is out of range
 */
export function proceduralPuff(name: string, seed: number, knobs = CARTOON_KNOBS, lobes = 10): PuffShape {
  requireRanges(knobs, lobes);
  const next = randomNumbers(seed);
  const around = Array.from({ length: lobes - 1 }, (_, index) => outerLobe(index, lobes - 1, knobs, next));
  const main: Lobe = { center: [0, 0, 0], radius: 0.72 - 0.2 * knobs.lumpiness };
  return { name, lobes: inUnitBall([main, ...around]) };
}

function requireRanges(knobs: PuffKnobs, lobes: number): void {
  for (const [knob, value] of Object.entries(knobs)) {
    if (!(value >= 0 && value <= 1)) throw new RangeError(`${knob} is ${value}: use a number from 0 to 1.`);
  }
  if (!Number.isInteger(lobes) || lobes < MIN_LOBES || lobes > MAX_LOBES) {
    throw new RangeError(`lobes is ${lobes}: use a whole number from ${MIN_LOBES} to ${MAX_LOBES}.`);
  }
}

function outerLobe(index: number, count: number, knobs: PuffKnobs, next: () => number): Lobe {
  const { lumpiness, flatness, roughness } = knobs;
  const jitter = (): number => 0.7 * roughness * (2 * next() - 1);
  const even = spherePoint(index, count);
  const [x, y, z] = normalized([even[0] + jitter(), even[1] + jitter(), even[2] + jitter()]);
  // Sizes alternate along the spiral: neighbours of equal size would look like a rosette.
  const size = index % 2 === 0 ? 1 : -1;
  const radius = 0.37 + roughness * (0.07 * size + 0.05 * (2 * next() - 1));
  const out = 0.86 - radius + 0.16 * lumpiness;
  return { center: [x * out, y * out * (1 - 0.55 * flatness), z * out], radius };
}

/**
 * Random numbers in [0, 1), 32 bits, after Steele, Lea and Flood, 'Fast Splittable Pseudorandom Number Generators'
 * (2014).
 */
function randomNumbers(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x9e3779b9) >>> 0;
    let bits = Math.imul(state ^ (state >>> 16), 0x21f0aaad);
    bits = Math.imul(bits ^ (bits >>> 15), 0x735a2d97);
    return ((bits ^ (bits >>> 15)) >>> 0) / 2 ** 32;
  };
}
