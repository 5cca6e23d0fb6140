import { sin } from '../simulator/exact/sine.ts';
import { emitterRig } from './emitterRig.ts';
import { ballMesh } from './models/ball.ts';
import { lathe } from './models/lathe.ts';
import { letter } from './models/letters.ts';
import { merged, placed, placement } from './models/place.ts';
import type { MovingPart, Placement, Scene, Vector } from './scene.ts';

/** Seconds until the sequence starts again. */
const LENGTH = 12;
/** Seconds at which the letters jump up, and those in which they fly up and settle. */
const RISES = [1.6, 2.1, 2.6, 3.1];
const [FLIGHT, SETTLING] = [0.22, 0.9];
/** Two hops of all letters, one after another, and the time at which they fall back. */
const HOP = { starts: [5.5, 8.1], gap: 0.15, length: 0.5, height: 0.34 };
const FALL = { start: 9.8, gap: 0.12, length: 0.24 };
/** Letters lie below the stage until they are seen. */
const HIDDEN = -0.62;

const NAMES = ['P', 'U', 'F', 'F'] as const;
const COLOR = [255, 244, 224] as const;
/** Distance of neighbouring letters. */
const PITCH = 1.08;
const DEPTH = 0.25;

/** A round stage out of which four letters jump. Every twelve seconds they fall back. */
export function title(): Scene {
  const look = { casts: true, inked: true };
  return {
    name: 'title',
    rig: RIG,
    rigids: [],
    rigidNames: [],
    surfaces: [
      ...stage(),
      ...NAMES.map((name, index) => ({ name: `${name} ${index + 1}`, mesh: letter(name), color: COLOR, part: index, ...look })), // prettier-ignore
    ],
    parts: NAMES.map((_, index): MovingPart => ({
      name: `Letter ${index + 1}`,
      pose: (seconds) => pose(index, seconds),
    })),
    camera: { target: [0, 0.55, 0], azimuth: 0.1, elevation: 0.17, distance: 7.6, fieldOfView: 0.5 },
    portrait: { minWidth: 0.76 },
    backdrop: { top: [20, 16, 58], bottom: [96, 66, 132] },
  };
}

/** The middle of a letter's foot. */
function foot(index: number): Vector {
  return [(index - 1.5) * PITCH, 0, DEPTH];
}

/** A letter lies on its back below the stage, swings up beyond upright, and settles. */
function pose(index: number, seconds: number): Placement {
  const time = seconds - Math.floor(seconds / LENGTH) * LENGTH;
  const [x, , z] = foot(index);
  const up = share(time - RISES[index], FLIGHT);
  const down = share(time - FALL.start - index * FALL.gap, FALL.length);
  const standing = (1 - (1 - up) * (1 - up)) * (1 - down * down);
  const settled = share(time - RISES[index] - FLIGHT, SETTLING);
  const sway = time > RISES[index] + FLIGHT ? (1 - settled) * (1 - settled) * sin(16 * settled) : 0;
  const hops = HOP.starts.map((start) => share(time - start - index * HOP.gap, HOP.length));
  const hopped = hops.reduce((sum, hop) => sum + 4 * HOP.height * hop * (1 - hop), 0);
  const height = HIDDEN * (1 - standing) + 0.22 * sway + hopped;
  return placement([x, Math.max(height, HIDDEN), z], [0.28 * sway - (Math.PI / 2) * (1 - standing), 0, 0.1 * sway]);
}

/** Share of a duration that has passed, 0 to 1. */
function share(time: number, duration: number): number {
  return Math.min(Math.max(time / duration, 0), 1);
}

/** A round stage with lamps along its edge. */
function stage(): Scene['surfaces'] {
  const top = lathe(80, [[0, -0.3], [2.86, -0.3]], [[2.86, -0.3], [2.95, -0.2], [2.9, -0.06], [2.78, 0]], [[2.78, 0], [0, 0]]); // prettier-ignore
  const base = lathe(80, [[0, -1.1], [2.3, -1.1]], [[2.3, -1.1], [2.62, -0.8], [2.68, -0.3]], [[2.68, -0.3], [0, -0.3]]); // prettier-ignore
  const lamps = Array.from({ length: 32 }, (_, index) => {
    const angle = (2 * Math.PI * index) / 32;
    return placed(ballMesh(0.075, 8), { at: [2.93 * sin(angle), -0.18, 2.93 * sin(angle + Math.PI / 2)] });
  });
  const look = { casts: false, inked: true };
  return [
    { name: 'stage', mesh: top, color: [126, 104, 186], ...look },
    { name: 'base', mesh: base, color: [86, 66, 146], ...look },
    { name: 'lamps', mesh: merged(...lamps), color: [255, 214, 132], ...look, glows: true },
  ];
}

/** A cloud for each letter, a comet, a curtain behind the letters, and mist around the stage. */
const RIG: Readonly<Record<string, number>> = {
  ...Object.assign({}, ...NAMES.map((_, index) => cloud(index))),
  ...emitter(4, [-5, 2, 0], { shape: 0, speed: 0.2, spread: 0.8, size: 0.24, share: 0 }),
  ...emitter(5, [0, 0.1, -0.75], { shape: 7, 'extent.x': 2, 'extent.y': 0, 'extent.z': 0, speed: 5.2, speedVariation: 0.6, spread: 0.5, size: 0.5, share: 0 }), // prettier-ignore
  ...emitter(6, [0, -0.95, 0], {
    shape: 3,
    radius: 2.75,
    inner: 0.85,
    speed: 0.12,
    spread: 1.2,
    size: 0.46,
    temperature: 0,
  }),
  'gravity.acceleration': 0.8,
  'buoyancy.acceleration': 1.1,
  'buoyancy.coolingTime': 1,
  'drag.rate': 1.8,
};

function cloud(index: number): Record<string, number> {
  const [x, , z] = foot(index);
  return emitter(index, [x, 0.35, z], { shape: 2, radius: 0.34, speed: 3.2, speedVariation: 0.5, spread: Math.PI, size: 0.36, share: 0 }); // prettier-ignore
}

function emitter(index: number, [x, y, z]: Vector, own: Record<string, number>): Record<string, number> {
  const all = { 'position.x': x, 'position.y': y, 'position.z': z, 'direction.y': 1, sizeVariation: 0.35, temperature: 1, ...own }; // prettier-ignore
  return emitterRig(index, all);
}
