import type { Color } from '../../renderer/gpu/ramps.ts';
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import type { Vector } from '../scene.ts';
import { ballMesh } from './ball.ts';
import { lathe } from './lathe.ts';
import { merged, placed } from './place.ts';
import { roundedBox } from './roundedBox.ts';

/** Radius of the mole, and half the length of its straight part, metres. */
export const MOLE_RADIUS = 0.34;
export const MOLE_HALF = 0.34;
const TOP = MOLE_HALF + MOLE_RADIUS;

const FUR: Color = [118, 92, 98];
const SNOUT: Color = [248, 168, 168];
const DARK: Color = [66, 46, 62];
const HELMET: Color = [250, 200, 72];
const LAMP: Color = [255, 246, 220];
const TEETH: Color = [255, 250, 240];
const SOIL: Color = [206, 132, 92];

/**
 * A mole in a miner's helmet, about the centre of its straight part, facing +z; and its molehill.
 * @param rigid index of the rigid that carries the mole
 * @param hill index of the part for the molehill
 */
export function mole(rigid: number, hill: number): SurfaceDescription[] {
  const look = { casts: true, inked: true, rigid };
  const small = { casts: false, inked: true, rigid };
  const flat = { casts: false, inked: false, rigid };
  const ball = (at: Vector, scale: Vector) => placed(ballMesh(1, 12), { at, scale });
  const both = ([x, y, z]: Vector, scale: Vector) => merged(ball([-x, y, z], scale), ball([x, y, z], scale));
  const teeth = placed(roundedBox([0.05, 0.05, 0.02], 0.015, 5), { at: [0, 0, 0.38] });
  return [
    { name: 'fur', mesh: fur(), color: FUR, ...look, group: 'mole' },
    { name: 'helmet', mesh: helmet(), color: HELMET, ...look },
    { name: 'miner lamp', mesh: ball([0, 0.52, 0.31], [0.09, 0.09, 0.06]), color: LAMP, ...small },
    { name: 'snout', mesh: ball([0, 0.1, 0.36], [0.13, 0.09, 0.12]), color: SNOUT, ...small },
    { name: 'nose', mesh: ball([0, 0.14, 0.47], [0.05, 0.04, 0.04]), color: DARK, ...flat },
    { name: 'mole eyes', mesh: both([0.14, 0.23, 0.29], [0.045, 0.06, 0.04]), color: DARK, ...flat },
    { name: 'teeth', mesh: teeth, color: TEETH, ...small },
    { name: 'paws', mesh: both([0.3, 0, 0.2], [0.1, 0.13, 0.08]), color: SNOUT, ...small },
    { name: 'molehill', mesh: molehill(), color: SOIL, casts: false, inked: true, part: hill },
  ];
}

function fur() {
  const side = [[MOLE_RADIUS * 0.7, -TOP], [MOLE_RADIUS, -MOLE_HALF], [MOLE_RADIUS, 0.1], [0.3, MOLE_HALF + 0.12], [0.16, TOP - 0.03], [0, TOP]] as const; // prettier-ignore
  return lathe(24, [[0, -TOP], side[0]], side);
}

function helmet() {
  return lathe(
    28,
    [[0, 0.3], [0.42, 0.3]],
    [[0.42, 0.3], [0.43, 0.33], [0.35, 0.37]],
    [[0.35, 0.37], [0.33, 0.55], [0.2, 0.7], [0, 0.75]],
  ); // prettier-ignore
}

/** A low dome that the mole pushes along while digging and stands in when it emerges. */
function molehill() {
  return lathe(
    28,
    [[0, -0.1], [0.62, -0.1]],
    [[0.62, -0.1], [0.55, 0.04], [0.38, 0.14], [0, 0.17]],
  ); // prettier-ignore
}
