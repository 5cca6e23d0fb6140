/** What a wipe emits: puffs that cover a picture at one known step, and clear afterwards. */
import type { Values } from '../../parameters/parameter.ts';
import { defaults } from '../../parameters/values.ts';
import type { EmissionOptions } from '../../simulator/emitterOptions.ts';
import type { Size } from '../size.ts';
import { AIR, emissionOptions, type Emission } from './emission.ts';
import { PIXELS_PER_METRE } from './placement.ts';

/** Seconds in which a puff grows, at the end of the time until everything is covered. */
const GROWTH = 0.35;
/** Seconds between the growth of the last puff and the change: pictures may hold an earlier moment, see `style.hold`. */
const SETTLED = 0.15;
/** Seconds that everything stays covered before the first puffs dissolve. */
const HOLD = 0.2;
/** Seconds in which a puff dissolves. */
const CLEARING = 0.7;
/** Rows of puffs along the shorter side, and the most puffs. */
const ROWS = 5;
const MAX_PUFFS = 300;
/**
 * Radius of puffs, relative to the distance between two of them. Balls of 0.71 would touch at the corners of the cells; lobes
 * leave gaps near the radius of a puff, and puffs move slowly.
 */
const RADIUS = 1.2;
/** Offsets of neighbouring puffs towards the viewer, relative to the distance between two of them. */
const DEPTHS = [0, 0.9, -0.9, 0.45, -0.45];

/** The air is still, so that puffs stay where they cover, also small ones. */
const STILL: Values = {
  'emission.growthTime': GROWTH,
  'emission.dissolve': 'erode',
  // Each puff has its own light and lines: the whole smoke is a wall, most of it in shadow.
  'style.form': 0,
  'style.simplify': 0,
  'style.shadows': 0,
  'light.azimuth': 25,
  'light.elevation': 35,
  'forces.turbulence': 0,
  'simulation.maxParticles': 2 * MAX_PUFFS,
};

/** Seconds from the first to the last puff. */
function sweepOf(duration: number): number {
  return Math.max(0, duration - GROWTH - SETTLED);
}

/** Each puff covers from `duration` on until the hold is over, and they go in the order in which they came. */
function lifeOf(duration: number): number {
  return duration + HOLD + CLEARING;
}

/** Seconds after the change until no picture shows a puff. */
export function clearedAfter(duration: number): number {
  return sweepOf(duration) + lifeOf(duration) + SETTLED - duration;
}

/** How a wipe moves. */
export interface WipeMotion {
  /** In degrees: 0 is to the right, 90 up. */
  readonly direction: number;
  /** Seconds until everything is covered. */
  readonly duration: number;
  readonly seed: number;
}

/** What a stage shows and emits at its first step. */
export interface Wipe {
  readonly values: Values;
  readonly emissions: readonly EmissionOptions[];
}

/**
 * A wipe for a stage of this size.
 * @param look values of style, light and puffs
 * @param color `#rrggbb` of all puffs
 */
export function makeWipe(look: Values, size: Size, motion: WipeMotion, color?: string): Wipe {
  const { direction, duration, seed } = motion;
  const tint = color === undefined ? {} : { 'style.tint1': color };
  const emissions = wipeEmissions(size, direction, duration).map(({ z, ...each }) => {
    const options = emissionOptions(each, [0, 0, 0], color === undefined ? 0 : 1);
    return { ...options, position: { ...options.position, z } };
  });
  const solid = (duration + HOLD) / lifeOf(duration);
  const density = `0:1,${solid.toFixed(2)}:1,1:0`;
  const values = { ...defaults(), ...AIR, ...onlySolid(look), ...tint, ...STILL, 'emission.density': density, seed };
  return { values, emissions };
}

/** A puff of a wipe. */
interface WipePuff extends Emission {
  /** Offset towards the viewer, so that puffs have lines where they overlap. */
  readonly z: number;
}

/** Puffs in rows that cover a canvas of this size and appear along a direction, in degrees: 0 is to the right, 90 up. */
export function wipeEmissions({ width, height }: Size, direction: number, duration: number): WipePuff[] {
  const [across, up] = [width, height].map((side) => side / PIXELS_PER_METRE);
  const cell = Math.max(Math.min(across, up) / ROWS, Math.sqrt((across * up) / (0.6 * MAX_PUFFS)));
  const columns = Math.ceil(across / cell) + 2;
  const rows = Math.ceil(up / cell) + 2;
  const angle = (direction * Math.PI) / 180;
  const [towardsX, towardsY] = [Math.cos(angle), Math.sin(angle)];
  const places = Array.from({ length: columns * rows }, (_, index) => {
    const row = Math.floor(index / columns);
    const shift = row % 2 ? 0.25 : -0.25;
    const x = (index % columns) - (columns - 1) / 2 + shift;
    const z = DEPTHS[((index % columns) + 2 * row) % DEPTHS.length];
    return [x * cell, (row - (rows - 1) / 2) * cell, z * cell] as const;
  });
  const ways = places.map(([x, y]) => x * towardsX + y * towardsY);
  const [first, last] = [Math.min(...ways), Math.max(...ways)];
  const sweep = sweepOf(duration);
  return places.map(([x, y, z], at) => ({
    shape: 'box',
    x,
    y,
    z,
    halfWidth: 0.05 * cell,
    halfHeight: 0.05 * cell,
    direction,
    spread: 20,
    speed: 0.2 * cell,
    speedVariation: 0.3,
    size: RADIUS * cell,
    sizeVariation: 0.08,
    life: lifeOf(duration),
    lifeVariation: 0,
    temperature: 1,
    delay: last > first ? (sweep * (ways[at] - first)) / (last - first) : 0,
    duration: 0,
    count: 1,
  }));
}

/** Colours, ink and light. Puffs of other shapes may have holes. */
function onlySolid(look: Values): Values {
  return Object.fromEntries(Object.entries(look).filter(([key]) => !key.startsWith('puff.')));
}
