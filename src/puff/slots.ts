/** The simulator's emitters and obstacles, handed out to calls. */
import { LIST_LIMIT } from '../preset/lists.ts';
import type { AnyValues, Value, Values } from '../preset/parameter.ts';
import { DRAG, type Emission, type Extent } from './effects.ts';

/** Air in which a puff neither rises nor falls at temperature 1, and keeps its temperature. */
const PULL = 6;
export const AIR: Values = {
  scene: 'air',
  'emission.rate': 0,
  'emission.lifetime': 1,
  'emission.growthTime': 0.14,
  'emission.density': '0:1,.4:.92,1:0',
  'gravity.acceleration': PULL,
  'buoyancy.acceleration': PULL,
  'buoyancy.coolingTime': 1000,
  'drag.rate': DRAG,
  'forces.turbulence': 1.5,
  'turbulence.scale': 0.6,
  'simulation.maxParticles': 1500,
};
/** Half depth of obstacles, metres: more than smoke spreads towards and away from the viewer. */
const DEPTH = 20;
/** Half depth of emitters, metres. */
const THIN = 0.08;
/** The simulator's limit, particles/s. */
const MAX_RATE = 20_000;
/** Where unused obstacles are, metres. */
const AWAY = 900;
/** A little longer than two steps: after this time an emitter has emitted all that it owes. */
const SETTLED = 0.05;
const DEGREE = Math.PI / 180;

/** A place in the plane of the page, metres. */
export interface ScenePoint {
  readonly x: number;
  readonly y: number;
}

/** An emission at a place and a simulated time. */
export interface PlacedEmission extends Emission {
  readonly at: ScenePoint;
  readonly tint: number;
}

interface Taken {
  readonly emission: PlacedEmission;
  readonly start: number;
  /** Values of an emitter that has moved. */
  readonly line?: Values;
}

/** The emitters. */
export class Emitters {
  private readonly taken: (Taken | undefined)[] = Array.from({ length: LIST_LIMIT });

  /** Number of emitters that are free at a simulated time. */
  free(time: number): number {
    return this.taken.filter((each) => isFree(each, time)).length;
  }

  /** Forgets all emissions. */
  clear(): void {
    this.taken.fill(undefined);
  }

  /** @returns the index of the emitter, which is free again after the emission */
  take(emission: PlacedEmission, start: number, now: number): number {
    const index = this.taken.findIndex((each) => isFree(each, now));
    this.taken[index] = { emission, start };
    return index;
  }

  /** Whether an emitter still belongs to an emission. */
  holds(index: number, emission: PlacedEmission): boolean {
    return this.taken[index]?.emission === emission;
  }

  /** Starts emissions at another time. */
  delay(indices: readonly number[], start: number): void {
    for (const index of indices) this.taken[index] = { ...this.taken[index]!, start };
  }

  /**
   * Moves an emitter along a line since the last frame, so that a fast one leaves no gaps.
   * @returns the values that change
   */
  moveAlong(index: number, from: ScenePoint, to: ScenePoint): Values {
    const line = lineBetween(from, to);
    this.taken[index] = { ...this.taken[index]!, line };
    return underKey(`emitters.${index}`, line);
  }

  /** Values of all emitters and of the rate that they share. */
  values(): Values {
    const rates = this.taken.map((each) => (each ? rateOf(each.emission) : 0));
    const total = rates.reduce((sum, rate) => sum + rate, 0);
    return Object.assign(
      { 'emission.rate': Math.min(total, MAX_RATE) },
      ...this.taken.map((each, index) =>
        underKey(`emitters.${index}`, {
          // Shares that add up to 0 would be rejected.
          share: total > 0 ? rates[index] / total : 1,
          ...emitter(each),
        }),
      ),
    ) as Values;
  }
}

function isFree(taken: Taken | undefined, time: number): boolean {
  return !taken || taken.start + taken.emission.delay + taken.emission.duration + SETTLED < time;
}

function rateOf({ count, duration }: Emission): number {
  return duration > 0 ? count / duration : 0;
}

function emitter(taken: Taken | undefined): Record<string, Value> {
  if (!taken) return { 'burst.count': 0, 'envelope.duration': 0 };
  const { emission, start, line } = taken;
  return {
    ...shapeOf(emission),
    ...strip(emission.at.x + emission.x, emission.at.y + emission.y),
    spread: emission.spread * DEGREE,
    speed: emission.speed,
    speedVariation: emission.speedVariation,
    size: emission.size,
    sizeVariation: emission.sizeVariation,
    lifetime: emission.life,
    lifetimeVariation: emission.lifeVariation,
    temperature: emission.temperature,
    tint: emission.tint,
    'burst.count': emission.duration > 0 ? 0 : emission.count,
    'envelope.start': start + emission.delay,
    'envelope.duration': emission.duration,
    ...line,
  };
}

function strip(x: number, y: number): Record<string, number> {
  return { 'position.x': rounded(x), 'position.y': rounded(y), 'position.z': 0 };
}

function shapeOf({ shape, direction = 90, halfWidth, halfHeight }: Emission): Record<string, Value> {
  if (shape === 'box') {
    return {
      shape: 'box',
      'extent.x': rounded(halfWidth),
      'extent.y': rounded(halfHeight),
      'extent.z': THIN,
      // Rounded, because the last bits differ between engines.
      'direction.x': rounded(Math.cos(direction * DEGREE)),
      'direction.y': rounded(Math.sin(direction * DEGREE)),
      'direction.z': 0,
    };
  }
  const isGround = shape === 'ground';
  return {
    shape: 'cone',
    radius: halfWidth,
    'direction.x': 0,
    'direction.y': isGround ? 1 : 0,
    'direction.z': isGround ? 0 : 1,
  };
}

function lineBetween(from: ScenePoint, to: ScenePoint): AnyValues {
  return {
    shape: 'line',
    ...strip((from.x + to.x) / 2, (from.y + to.y) / 2),
    'extent.x': rounded((to.x - from.x) / 2),
    'extent.y': rounded((to.y - from.y) / 2),
    'extent.z': 0,
  };
}

/** The obstacles. When there are too many, the oldest goes. */
export class Obstacles {
  private readonly taken: (object | undefined)[] = Array.from({ length: LIST_LIMIT });
  private next = 0;

  /** Values of an obstacle with these half sides. @param owner frees it */
  take(owner: object, at: ScenePoint, { halfWidth, halfHeight }: Extent): Values {
    const free = this.taken.indexOf(undefined);
    const index = free >= 0 ? free : this.next++ % LIST_LIMIT;
    this.taken[index] = owner;
    return underKey(`colliders.${index}`, {
      shape: 'box',
      ...strip(at.x, at.y),
      'halfExtents.x': Math.max(rounded(halfWidth), 0.001),
      'halfExtents.y': Math.max(rounded(halfHeight), 0.001),
      'halfExtents.z': DEPTH,
      friction: 0,
      // Along a perfectly smooth box, dying puffs would form a straight edge.
      roughness: 1,
    });
  }

  /** Values that remove the obstacles of an owner; of all without one. */
  release(owner?: object): Values {
    const gone = this.taken.flatMap((each, index) => (each && (!owner || each === owner) ? [index] : []));
    for (const index of gone) this.taken[index] = undefined;
    return Object.assign({}, ...gone.map((index) => underKey(`colliders.${index}`, strip(AWAY, AWAY)))) as Values;
  }
}

function underKey(prefix: string, values: AnyValues): Values {
  return Object.fromEntries(Object.entries(values).map(([key, value]) => [`${prefix}.${key}`, value]));
}

function rounded(metres: number): number {
  return Math.round(metres * 1000) / 1000;
}
