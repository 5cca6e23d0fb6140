/** What the stage emits for an effect, and the air around it. */
import { rounded, type Triple } from '../plane.ts';
import type { Values } from '../../parameters/parameter.ts';
import type { VectorComponents, EmissionChange, EmissionOptions, PuffOptions } from '../../simulator/emitterOptions.ts';

/** An emitter for a while. Directions are in degrees: 0 is right, 90 up. */
export interface Emission {
  /** A box; or a disc that faces the viewer, or lies flat, from whose centre puffs leave to all sides. */
  readonly shape: 'box' | 'front' | 'ground';
  /** Offset from the middle of the target, and half sides. */
  readonly x: number;
  readonly y: number;
  readonly halfWidth: number;
  readonly halfHeight: number;
  /** Undefined for discs. */
  readonly direction?: number;
  /** Half angle of the cone in which puffs leave, degrees. */
  readonly spread: number;
  readonly speed: number;
  readonly speedVariation: number;
  /** Radius of the puffs. */
  readonly size: number;
  readonly sizeVariation: number;
  /** Lifetime of the puffs, and its largest random change as a fraction. */
  readonly life: number;
  readonly lifeVariation: number;
  /** Puffs rise above 1 and fall below, see `AIR`. */
  readonly temperature: number;
  /** Start after that of the effect. */
  readonly delay: number;
  /** 0 for a burst. */
  readonly duration: number;
  readonly count: number;
}

/** Drag of the air, 1/s: a puff of speed v comes to rest after v / DRAG metres. */
export const DRAG = 2.4;
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
/** Half depth of emitters, metres. */
const THIN = 0.08;
const DEGREE = Math.PI / 180;

/** Options of the stage for an emission around a place in the plane of the page. */
export function emissionOptions(emission: Emission, [x, y]: Triple, tint: number): EmissionOptions {
  const { speed, speedVariation, size, sizeVariation, count, duration, delay } = emission;
  return {
    ...shapeOf(emission),
    position: flat(x + emission.x, y + emission.y),
    spread: emission.spread * DEGREE,
    speed,
    speedVariation,
    size,
    sizeVariation,
    lifetime: emission.life,
    lifetimeVariation: emission.lifeVariation,
    temperature: emission.temperature,
    tint,
    count,
    duration: duration || undefined,
    delay,
  };
}

function shapeOf({
  shape,
  direction = 90,
  halfWidth,
  halfHeight,
}: Emission): PuffOptions & Pick<EmissionOptions, 'direction'> {
  if (shape !== 'box') {
    return {
      shape: 'cone',
      radius: halfWidth,
      direction: shape === 'ground' ? { x: 0, y: 1, z: 0 } : { x: 0, y: 0, z: 1 },
    };
  }
  const angle = direction * DEGREE;
  // Rounded, because the last bits differ between engines.
  return {
    shape,
    extent: { ...flat(halfWidth, halfHeight), z: THIN },
    direction: flat(Math.cos(angle), Math.sin(angle)),
  };
}

/** Moves an emission along a line since the last frame, so that a fast one leaves no gaps. */
export function alongLine([x, y]: Triple, [toX, toY]: Triple): EmissionChange {
  return { shape: 'line', position: flat((x + toX) / 2, (y + toY) / 2), extent: flat((toX - x) / 2, (toY - y) / 2) };
}

function flat(x: number, y: number): VectorComponents {
  return { x: rounded(x), y: rounded(y), z: 0 };
}
