/** A small sitting dragon that faces +x, and the gold that it sits on. Metres; the ground is at height 0. */
import type { Color } from '../../../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../../renderer/passes/surface.ts';
import { cos, sin } from '../../../simulator/exact/sine.ts';
import type { Vector } from '../../scene.ts';
import { ballMesh } from '../ball.ts';
import { lathe, tube } from '../lathe.ts';
import { merged, placed } from '../place.ts';

export const SCALES: Color = [72, 176, 160];
export const BELLY: Color = [255, 232, 176];
export const FINS: Color = [244, 116, 96];
export const HORN: Color = [255, 244, 220];
const GOLD: Color = [250, 200, 84];

export const NONE: Vector = [0, 0, 0];

/** Where the parts turn; the chest slides along its pose instead. */
export const PIVOTS = {
  neck: [0.02, 1.16, 0],
  leftWing: [-0.34, 1.2, 0.26],
  rightWing: [-0.34, 1.2, -0.26],
  tail: [-0.3, 0.36, 0],
} as const satisfies Record<string, Vector>;

/** Indices of the parts that carry surfaces. */
export interface DragonParts {
  readonly chest: number;
  readonly neck: number;
  readonly tail: number;
}

/** Everything but head and wings. */
export function dragonBody({ chest, neck, tail }: DragonParts): SurfaceDescription[] {
  const look = { casts: true, inked: true };
  const scales = { ...look, color: SCALES, group: 'dragon' };
  const plates = (all: readonly TriangleMesh[], parity: 0 | 1) => merged(...all.filter((_, at) => at % 2 === parity));
  return [
    { name: 'body', mesh: body(), ...scales },
    { name: 'chest', mesh: ball([0.16, 0.94, 0], [0.5, 0.52, 0.5]), ...scales, part: chest },
    { name: 'neck', mesh: neckMesh(), ...scales, part: neck },
    { name: 'tail', mesh: tailMesh(), ...scales, part: tail },
    { name: 'tail fin', mesh: tailFin(), color: FINS, ...look, part: tail },
    { name: 'tail spikes', mesh: merged(...TAIL_SPIKES.map(spike)), color: FINS, ...look, part: tail },
    { name: 'even plates', mesh: plates(BELLY_PLATES, 0), color: BELLY, ...look, part: chest },
    { name: 'odd plates', mesh: plates(BELLY_PLATES, 1), color: BELLY, ...look, part: chest },
    { name: 'even neck plates', mesh: plates(NECK_PLATES, 0), color: BELLY, ...look, part: neck },
    { name: 'odd neck plates', mesh: plates(NECK_PLATES, 1), color: BELLY, ...look, part: neck },
    { name: 'back spikes', mesh: merged(...BACK_SPIKES.map(spike)), color: FINS, ...look },
    { name: 'neck spikes', mesh: merged(...NECK_SPIKES.map(spike)), color: FINS, ...look, part: neck },
    { name: 'haunches', mesh: both(haunch), color: SCALES, ...look },
    { name: 'feet', mesh: both(foot), color: SCALES, ...look },
    { name: 'arms', mesh: both(arm), color: SCALES, ...look },
    { name: 'claws', mesh: both(claws), color: HORN, ...look, casts: false },
  ];
}

export function both(make: (side: 1 | -1) => TriangleMesh): TriangleMesh {
  return merged(make(1), make(-1));
}

/** An ellipsoid. */
export function ball(at: Vector, scale: Vector, angles: Vector = NONE, rings = 14): TriangleMesh {
  return placed(ballMesh(1, rings), { at, scale, angles });
}

/** A cone that leans back by an angle, in radians. */
export function spike([x, y, z, size, lean]: readonly [number, number, number, number, number]): TriangleMesh {
  const cone = lathe(
    10,
    [[0, -0.06], [0.5, 0]],
    [[0.5, 0], [0.34, 0.5], [0, 1.1]],
  ); // prettier-ignore
  return placed(cone, { at: [x, y, z], angles: [0, 0, lean], scale: [size, size, 0.5 * size] });
}

function body(): TriangleMesh {
  const egg = lathe(
    36,
    [[0, -0.02], [0.5, 0.02]],
    [[0.5, 0.02], [0.7, 0.28], [0.7, 0.6], [0.56, 1], [0.38, 1.3], [0, 1.46]],
  ); // prettier-ignore
  return placed(egg, { at: [-0.05, 0, 0], angles: [0, 0, 0.05], scale: [1, 1, 0.94] });
}

/** Plates over the front of the chest, from the lowest up: height, distance from the middle, half width. */
const BELLY_PLATES = ([[0.36, 0.61, 0.36], [0.6, 0.63, 0.4], [0.84, 0.645, 0.4], [1.07, 0.61, 0.36], [1.27, 0.51, 0.29]] as const).map(
  ([y, x, width]) => ball([x - 0.03, y, 0], [0.13, 0.16, width], [0, 0, 1.1 * (y - 0.7)]),
); // prettier-ignore

const NECK_PATH: readonly Vector[] = [[0, -0.2, 0], [0.12, 0.22, 0], [0.12, 0.58, 0], [0.28, 0.98, 0]]; // prettier-ignore

function neckMesh(): TriangleMesh {
  return tube(28, NECK_PATH, [0, 0, 1], [[0, 0], [0.4, 0.02]], [[0.4, 0.02], [0.34, 0.35], [0.27, 0.7], [0.26, 0.98]], [[0.26, 0.98], [0, 1]]); // prettier-ignore
}

const NECK_PLATES = ([[0.46, 0.22, 0.25, 0.1], [0.435, 0.41, 0.23, 0], [0.42, 0.58, 0.21, -0.2], [0.47, 0.75, 0.19, -0.5]] as const).map(
  ([x, y, width, angle]) => ball([x - 0.02, y, 0], [0.1, 0.13, width], [0, 0, angle]),
); // prettier-ignore

/** Position, size and lean of each spike. */
const BACK_SPIKES = [[-0.42, 1.16, 0, 0.25, 1.0], [-0.62, 0.88, 0, 0.27, 1.25], [-0.72, 0.56, 0, 0.25, 1.5]] as const; // prettier-ignore
const NECK_SPIKES = [[-0.16, 0.72, 0, 0.22, 1.1], [-0.22, 0.46, 0, 0.24, 1.35], [-0.28, 0.2, 0, 0.25, 1.2]] as const; // prettier-ignore
const TAIL_SPIKES = [[-0.52, 0.08, 0.04, 0.2, 0.7], [-0.86, -0.02, 0.24, 0.17, 0.4], [-1.04, -0.06, 0.58, 0.15, 0.1]] as const; // prettier-ignore

/** From the pivot of the tail, along the ground around the dragon's left, with a raised tip. */
const TAIL_PATH: readonly Vector[] = [[0.1, 0, 0], [-0.45, -0.14, 0.02], [-0.92, -0.22, 0.3], [-1.02, -0.22, 0.8], [-0.66, -0.22, 1.16], [-0.16, -0.16, 1.26], [0.16, 0.12, 1.28]]; // prettier-ignore
const UP: Vector = [0, 1, 0];

function tailMesh(): TriangleMesh {
  return tube(22, TAIL_PATH, UP, [[0, 0], [0.36, 0.01]], [[0.36, 0.01], [0.27, 0.22], [0.19, 0.45], [0.13, 0.7], [0.07, 0.99]], [[0.07, 0.99], [0, 1]]); // prettier-ignore
}

/** A spade at the tip of the tail. */
function tailFin(): TriangleMesh {
  const spade = lathe(
    14,
    [[0, -0.06], [0.07, -0.04], [0.22, 0], [0.2, 0.1], [0.09, 0.27], [0, 0.42]],
  ); // prettier-ignore
  return placed(spade, { at: [0.16, 0.12, 1.28], angles: [0, 0, -0.55], scale: [1, 1, 0.42] });
}

function haunch(side: 1 | -1): TriangleMesh {
  return ball([0.1, 0.4, side * 0.52], [0.46, 0.4, 0.24], [0, -0.1 * side, 0.2]);
}

function foot(side: 1 | -1): TriangleMesh {
  return ball([0.46, 0.13, side * 0.56], [0.34, 0.15, 0.2], [0, -0.18 * side, 0]);
}

/** The arms rest on the belly. */
function arm(side: 1 | -1): TriangleMesh {
  const path: readonly Vector[] = [[0.2, 1.06, side * 0.4], [0.36, 0.86, side * 0.5], [0.6, 0.78, side * 0.38], [0.74, 0.8, side * 0.26]]; // prettier-ignore
  const limb = tube(16, path, UP, [[0, 0], [0.11, 0.02], [0.15, 0.12], [0.13, 0.5], [0.1, 0.97], [0, 1]]); // prettier-ignore
  return merged(limb, ball([0.76, 0.8, side * 0.24], [0.13, 0.11, 0.12]));
}

/** Three on each foot and two on each hand. */
function claws(side: 1 | -1): TriangleMesh {
  const toes = [-1, 0, 1].map((toe) => ball([0.76 - 0.04 * toe * toe, 0.09, side * 0.62 + 0.13 * toe], [0.1, 0.06, 0.05], NONE, 7)); // prettier-ignore
  const fingers = [0, 1].map((finger) => ball([0.85, 0.81 - 0.08 * finger, side * (0.24 - 0.07 * finger)], [0.07, 0.04, 0.045], NONE, 7)); // prettier-ignore
  return merged(...toes, ...fingers);
}

/** A heap of coins and gems with an egg, and coins that have rolled away. */
export function gold(): SurfaceDescription[] {
  const heap = lathe(
    48,
    [[0, -0.06], [1.7, -0.06]],
    [[1.7, -0.06], [1.6, 0.05], [1.3, 0.17], [0.8, 0.22], [0, 0.23]],
  ); // prettier-ignore
  const coin = lathe(14, [[0, -0.03], [0.13, -0.03]], [[0.13, -0.03], [0.13, 0.03]], [[0.13, 0.03], [0, 0.03]]); // prettier-ignore
  const coins = Array.from({ length: 46 }, (_, index) => {
    const [angle, share] = [2.4 * index, (0.618 * index) % 1];
    const out = index < 34 ? 0.85 + 0.8 * share : 1.8 + 0.5 * share;
    const [height, tilt] = index < 34 ? [0.23 - 0.24 * (out - 0.85) * (out - 0.85), 0.32] : [0.03, 0.02];
    return placed(coin, {
      at: [out * cos(angle), height, out * sin(angle)],
      angles: [tilt * sin(5.1 * index), 0, tilt * cos(3.7 * index)],
    });
  });
  const gem = ([x, y, z, size]: readonly [number, number, number, number]) =>
    placed(lathe(6, [[0, -0.8], [1, 0]], [[1, 0], [0.6, 0.6]], [[0.6, 0.6], [0, 0.6]]), { at: [x, y, z], scale: size, angles: [0.3, x, 0.2] }); // prettier-ignore
  const egg = lathe(24, [[0, 0], [0.16, 0.02], [0.26, 0.2], [0.2, 0.44], [0, 0.58]]); // prettier-ignore
  const spots = SPOTS.map(([x, y, z, size]) => ball([x, y, z], [size, size, 0.5 * size], [0, 0.5, 0], 8));
  const nest = (mesh: TriangleMesh) => placed(mesh, { at: [0.95, 0.12, 1.12], angles: [0.1, 0.3, -0.16] });
  return [
    { name: 'egg', mesh: nest(egg), color: HORN, casts: true, inked: true },
    { name: 'spots', mesh: nest(merged(...spots)), color: SCALES, casts: false, inked: false },
    { name: 'heap', mesh: heap, color: [236, 174, 72], casts: false, inked: true },
    { name: 'coins', mesh: merged(...coins), color: GOLD, casts: true, inked: true },
    { name: 'rubies', mesh: merged(...RUBIES.map(gem)), color: [232, 72, 104], casts: true, inked: true },
    { name: 'sapphires', mesh: merged(...SAPPHIRES.map(gem)), color: [92, 132, 232], casts: true, inked: true },
  ];
}

/** Position and radius of each spot on the egg. */
const SPOTS = [[0.1, 0.2, 0.23, 0.06], [-0.1, 0.34, 0.21, 0.05], [0.19, 0.38, 0.1, 0.045], [-0.17, 0.14, 0.17, 0.045], [0.04, 0.47, 0.15, 0.035]] as const; // prettier-ignore
/** Position and radius of each gem. */
const RUBIES = [[1.28, 0.22, 0.42, 0.12], [0.5, 0.2, 1.5, 0.1], [-0.2, 0.24, -1.4, 0.12]] as const; // prettier-ignore
const SAPPHIRES = [[1.4, 0.2, 0.75, 0.11], [1.5, 0.14, -0.6, 0.12], [-1.55, 0.14, 0.3, 0.1]] as const; // prettier-ignore
