/** Puff shapes made from a seed and three knobs. The same seed and knobs make the same shape everywhere. */
import { inUnitBall, MAX_LOBES } from './lobes.ts';
import type { Lobe, PuffShape } from './shapes.ts';
import { normalized, spherePoint } from './vector.ts';

/** All from 0 to 1. */
export interface PuffKnobs {
  /** How far lobes stand out of the main mass: 0 is nearly a ball, 1 a bunch. */
  readonly lumpiness: number;
  /** How much the puff is pressed along its own y axis: 0 is as tall as wide, 1 a cushion. */
  readonly flatness: number;
  /** How unequal and how unevenly spread the lobes are. */
  readonly roughness: number;
}

/** What three quarters of a cartoon's clouds look like: clearly lobed, of large and small. */
export const CARTOON_KNOBS: PuffKnobs = { lumpiness: 0.55, flatness: 0.1, roughness: 0.5 };

/** Fewer lobes than this look like a bunch of balls. */
const MIN_LOBES = 5;

/**
 * A main mass with `lobes - 1` lobes on all its sides, large and small in turn.
 * @param lobes 5..{@link MAX_LOBES}
 * @throws RangeError naming the knob or the number that is out of its range
 */
export function proceduralPuff(name: string, seed: number, knobs = CARTOON_KNOBS, lobes = 10): PuffShape {
  demandRanges(knobs, lobes);
  const next = randomNumbers(seed);
  const around = Array.from({ length: lobes - 1 }, (_, index) => outerLobe(index, lobes - 1, knobs, next));
  const main: Lobe = { center: [0, 0, 0], radius: 0.72 - 0.2 * knobs.lumpiness };
  return { name, lobes: inUnitBall([main, ...around]) };
}

function demandRanges(knobs: PuffKnobs, lobes: number): void {
  for (const [knob, value] of Object.entries(knobs)) {
    if (!(value >= 0 && value <= 1)) throw new RangeError(`${knob} is ${value}; it takes a number from 0 to 1.`);
  }
  if (!Number.isInteger(lobes) || lobes < MIN_LOBES || lobes > MAX_LOBES) {
    throw new RangeError(`lobes is ${lobes}; it takes a whole number from ${MIN_LOBES} to ${MAX_LOBES}.`);
  }
}

function outerLobe(index: number, count: number, knobs: PuffKnobs, next: () => number): Lobe {
  const { lumpiness, flatness, roughness } = knobs;
  const jitter = (): number => 0.7 * roughness * (2 * next() - 1);
  const even = spherePoint(index, count);
  const [x, y, z] = normalized([even[0] + jitter(), even[1] + jitter(), even[2] + jitter()]);
  // Large and small in turn along the spiral: like sizes side by side would read as a rosette.
  const size = index % 2 === 0 ? 1 : -1;
  const radius = 0.37 + roughness * (0.07 * size + 0.05 * (2 * next() - 1));
  const out = 0.86 - radius + 0.16 * lumpiness;
  return { center: [x * out, y * out * (1 - 0.55 * flatness), z * out], radius };
}

/** Numbers from 0 to 1, after Steele, Lea and Flood, 'Fast Splittable Pseudorandom Number Generators' (2014), 32 bits. */
function randomNumbers(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x9e3779b9) >>> 0;
    let bits = Math.imul(state ^ (state >>> 16), 0x21f0aaad);
    bits = Math.imul(bits ^ (bits >>> 15), 0x735a2d97);
    return ((bits ^ (bits >>> 15)) >>> 0) / 2 ** 32;
  };
}
