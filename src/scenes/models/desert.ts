/** A round piece of desert with rocks and cacti. Metres; the sand is at height 0. */
import type { Color } from '../../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import { cos, sin } from '../../simulator/exact/sine.ts';
import type { RigidDescription } from '../../simulator/rigid.ts';
import type { Vector } from '../scene.ts';
import { ballMesh } from './ball.ts';
import { friendlyFace } from './face.ts';
import { island } from './island.ts';
import { lathe, pipe } from './lathe.ts';
import { merged, placed } from './place.ts';

/** Radius of the sand. */
export const DESERT_RADIUS = 3.1;

const SAND: Color = [250, 204, 132];
const SOIL: Color = [206, 122, 92];
const ROCK: Color = [228, 128, 96];
const LEAF: Color = [92, 172, 112];
const BLOSSOM: Color = [242, 112, 146];
const DARK: Color = [66, 46, 62];
const CHEEK: Color = [240, 138, 122];

/** Position and size of each cactus. */
const CACTI = [
  [-1.9, -1.5, 1.25],
  [1.95, -1.6, 0.95],
  [-2.45, 0.35, 0.7],
] as const;

/** Centres and radii of the rocks, which are partly buried. */
const ROCKS = [
  [2.5, 0.02, -0.45, 0.36],
  [2.42, -0.04, 0.25, 0.24],
  [-0.5, 0.02, -2.45, 0.42],
  [0.15, -0.05, -2.6, 0.3],
] as const;

export function desert(): SurfaceDescription[] {
  const rocks = merged(...ROCKS.map(([x, y, z, radius]) => placed(ballMesh(radius, 10), { at: [x, y, z] })));
  return [
    ...island(DESERT_RADIUS, SAND, SOIL),
    { name: 'rocks', mesh: rocks, color: ROCK, casts: true, inked: true },
    ...cacti(),
  ];
}

/** Colliders for falling objects: the sand, the trunks of the cacti, and the rocks. */
export function desertRigids(): RigidDescription[] {
  const ground = { kind: 'fixed', restitution: 0.4, friction: 0.7, position: [0, 0, 0] } as const;
  const trunks = CACTI.map(([x, z, scale]) => ({
    shape: { type: 'capsule' as const, halfHeight: 0.55 * scale, radius: 0.28 * scale },
    position: [x, 0.6 * scale, z] as const,
  }));
  const rocks = ROCKS.map(([x, y, z, radius]) => ({
    shape: { type: 'ball' as const, radius },
    position: [x, y, z] as const,
  }));
  return [
    { ...ground, shape: { type: 'cylinder', halfHeight: 0.3, radius: DESERT_RADIUS - 0.05 }, position: [0, -0.3, 0] },
    { ...ground, shape: { type: 'compound', parts: trunks } },
    { ...ground, shape: { type: 'compound', parts: rocks } },
  ];
}

function cacti(): SurfaceDescription[] {
  const each = (mesh: TriangleMesh) =>
    merged(...CACTI.map(([x, z, scale]) => placed(mesh, { at: [x, -0.03, z], scale, angles: [0, -0.2 * x, 0] })));
  const face = friendlyFace(0.42, 0.3);
  const front = { at: [0, 0.98, 0.28] } as const;
  const flat = { casts: false, inked: false };
  return [
    { name: 'cacti', mesh: each(cactus()), color: LEAF, casts: true, inked: true },
    { name: 'blossoms', mesh: each(blossoms()), color: BLOSSOM, casts: false, inked: true },
    { name: 'cactus eyes', mesh: each(placed(face.features, front)), color: DARK, ...flat },
    { name: 'cactus cheeks', mesh: each(placed(face.cheeks, front)), color: CHEEK, ...flat },
  ];
}

/** A closed mesh of a trunk with two arms. */
function cactus(): TriangleMesh {
  const trunk = lathe(20, [[0, -0.1], [0.25, -0.1]], [[0.25, -0.1], [0.3, 0.5], [0.3, 1], [0.22, 1.35], [0, 1.46]]); // prettier-ignore
  const arm = (angle: number, y: number) =>
    placed(
      pipe(
        14,
        [[0.1, 0], [0.36, 0], [0.52, 0.1], [0.54, 0.3], [0.54, 0.5]],
        [[0, 0], [0.11, 0]],
        [[0.11, 0], [0.13, 0.4], [0.13, 0.8], [0.08, 0.95], [0, 1]],
      ),
      { at: [0, y, 0], angles: [0, angle, 0] },
    ); // prettier-ignore
  return merged(trunk, arm(0, 0.66), arm(Math.PI, 0.5));
}

function blossoms(): TriangleMesh {
  const at = (petal: number): Vector => {
    const angle = (2 * Math.PI * petal) / 5;
    return [0.09 * cos(angle), 1.47, 0.09 * sin(angle)];
  };
  return merged(...[0, 1, 2, 3, 4].map((petal) => placed(ballMesh(0.075, 8), { at: at(petal) })));
}
