/** The smoke of `puff.wipe()`: it covers the page or an element at one known step, and clears afterwards. */
import { ContextError, LoadError } from '../../base/errors.ts';
import type { Values } from '../../parameters/parameter.ts';
import { defaults } from '../../parameters/values.ts';
import type { RemoteStage } from '../../stage/remote/contract.ts';
import { openStage } from '../../stage/remote/openStage.ts';
import { asSmokeError } from '../asSmokeError.ts';
import { sizeOf, type Size } from '../size.ts';
import { Cover } from './cover.ts';
import { AIR, emissionOptions, type Emission } from './emission.ts';
import { hexOf, lookOf } from './look.ts';
import type { WipeOptions } from './options.ts';
import { PIXELS_PER_METRE } from './placement.ts';
import type { Source } from './target.ts';

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
/** The worker presents the empty picture before it ends, milliseconds. */
const GRACE_MS = 1000;
/** Frames of the page until it shows what the worker drew last. */
const FRAMES = 3;
/** Interval in which the simulated time is read near the end of a wait, milliseconds. */
const MIN_INTERVAL_MS = 30;

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

/**
 * The values of a stage for a wipe.
 * @param look values of style and light
 */
export function wipeValues(look: Values, duration: number, seed: number): Values {
  const solid = (duration + HOLD) / lifeOf(duration);
  const density = `0:1,${solid.toFixed(2)}:1,1:0`;
  return { ...defaults(), ...AIR, ...look, ...STILL, 'emission.density': density, seed };
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

/**
 * Covers the target with smoke, changes the page while everything is covered, and clears the smoke.
 * @param source the page if absent
 * @param change called once
 * @param signal removes the smoke at once
 * @returns resolves when the smoke is gone
 * @throws UnsupportedError, LoadError or ContextError when smoke cannot be drawn
 */
export async function playWipe(
  source: Source | undefined,
  options: WipeOptions,
  change: () => Promise<void>,
  signal: AbortSignal,
): Promise<void> {
  const cover = new Cover(source, options.zIndex);
  let stage: RemoteStage | undefined;
  try {
    const { duration = 0.9, direction = 0, color, seed = Math.floor(Math.random() * 2 ** 32) } = options;
    const look = await lookOf(options.preset);
    const tint = color === undefined ? {} : { 'style.tint1': hexOf(color, source?.inside) };
    const size = sizeOf(cover.canvas);
    const values = wipeValues({ ...onlySolid(look), ...tint }, duration, seed);
    const opened = { values, ...size, quality: 'auto', background: false, historyBytes: 0, graceMs: GRACE_MS } as const;
    stage = await openStage(() => cover.makeCanvas(), { ...opened, signal });
    const failure = failureOf(stage, signal);
    const emissions = wipeEmissions(size, direction, duration);
    await Promise.race([failure, play(stage, emissions, color === undefined ? 0 : 1, duration, change, cover)]);
  } catch (error) {
    if (!signal.aborted) throw asSmokeError(error);
  } finally {
    stage?.dispose().catch(() => undefined);
    cover.remove();
  }
}

async function play(
  stage: RemoteStage,
  emissions: readonly WipePuff[],
  tint: number,
  duration: number,
  change: () => Promise<void>,
  cover: Cover,
): Promise<void> {
  const emitted = emissions.map((each) => {
    const options = emissionOptions(each, [0, 0, 0], tint);
    return stage.emit({ ...options, position: { ...options.position, z: each.z } });
  });
  await Promise.all(emitted);
  await stage.play();
  await reached(stage, duration);
  await stage.pause();
  // Exactly this step, back or forth: the same picture on every machine.
  await stage.seek(duration);
  await pageShown();
  // The caller reports its failure; the smoke clears nevertheless.
  await change().catch(() => undefined);
  cover.place();
  await pageShown();
  await stage.play();
  await reached(stage, sweepOf(duration) + lifeOf(duration));
}

/** Rejects when the stage fails, or is no longer wanted. */
function failureOf(stage: RemoteStage, signal: AbortSignal): Promise<never> {
  return new Promise((_, reject) => {
    stage.on('error', (error) => {
      // The stage goes on without what could not be fetched.
      if (!(error instanceof LoadError)) reject(error);
    });
    signal.addEventListener('abort', () => reject(new ContextError('The wipe was cancelled.')));
  });
}

/** Resolves when the simulation has reached a time. */
async function reached(stage: RemoteStage, time: number): Promise<void> {
  for (;;) {
    const { time: now } = await stage.stats();
    if (now >= time) return;
    await new Promise((resolve) => setTimeout(resolve, Math.max(MIN_INTERVAL_MS, 1000 * (time - now))));
  }
}

/** Resolves when the page has the latest picture. In a hidden tab it never does, and the wipe ends. */
async function pageShown(): Promise<void> {
  for (let frame = 0; frame < FRAMES; ++frame) await new Promise(requestAnimationFrame);
}

/** Colours, ink and light. Puffs of other shapes may have holes. */
function onlySolid(look: Values): Values {
  return Object.fromEntries(Object.entries(look).filter(([key]) => !key.startsWith('puff.')));
}
