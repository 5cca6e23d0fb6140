/** Round floating islands for toys, and their trees. */
import type { Color } from '../../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import { ballMesh } from './ball.ts';
import { lathe } from './lathe.ts';
import { merged, placed } from './place.ts';

const SEGMENTS = 72;

/** An island with its top at height 0, and soil that tapers off below. */
export function island(radius: number, grass: Color, soil: Color): SurfaceDescription[] {
  const turf = lathe(
    SEGMENTS,
    [[0, -0.14], [radius - 0.04, -0.14]],
    [[radius - 0.04, -0.14], [radius, -0.07], [radius - 0.06, 0]],
    [[radius - 0.06, 0], [0, 0]],
  ); // prettier-ignore
  const root = lathe(
    SEGMENTS,
    [[0, -0.62], [radius * 0.45, -0.56], [radius * 0.78, -0.4], [radius * 0.94, -0.12]],
    [[radius * 0.94, -0.12], [0, -0.12]],
  ); // prettier-ignore
  return [
    { name: 'turf', mesh: turf, color: grass, casts: false, inked: true },
    { name: 'soil', mesh: root, color: soil, casts: false, inked: true },
  ];
}

/** Position and height of a tree, metres. */
export type Tree = readonly [x: number, z: number, height: number];

/** Round trees: spherical crowns on short trunks. */
export function trees(stands: readonly Tree[], crown: Color, trunk: Color): SurfaceDescription[] {
  const look = { casts: true, inked: true };
  return [
    { name: 'trunks', mesh: merged(...stands.map(trunkMesh)), color: trunk, ...look },
    { name: 'crowns', mesh: merged(...stands.map(crownMesh)), color: crown, ...look },
  ];
}

function trunkMesh([x, z, height]: Tree): TriangleMesh {
  const radius = 0.1 * height;
  const trunk = lathe(10, [[0, -0.02], [radius, -0.02]], [[radius, -0.02], [radius * 0.7, height * 0.5]], [[radius * 0.7, height * 0.5], [0, height * 0.5]]); // prettier-ignore
  return placed(trunk, { at: [x, 0, z] });
}

function crownMesh([x, z, height]: Tree): TriangleMesh {
  const ball = (share: number, up: number, aside: number) =>
    placed(ballMesh(1, 12), {
      at: [x + aside * height, up * height, z + 0.3 * aside * height],
      scale: [share * height, share * 0.92 * height, share * height],
    });
  return merged(ball(0.32, 0.58, 0), ball(0.24, 0.86, 0.04), ball(0.2, 0.5, 0.24), ball(0.2, 0.52, -0.22));
}
