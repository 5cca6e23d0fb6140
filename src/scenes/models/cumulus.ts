import type { TriangleMesh } from '../../passes/extrusion.ts';
import { ballMesh } from './ball.ts';
import { merged, placed } from './place.ts';

/** Where a cloud's flat base has its middle, and half of its width; metres. */
export type Cumulus = readonly [x: number, y: number, z: number, half: number];

/** Heaps of a cloud of half width 1: where their middles are over its base, and their radii. */
const HEAPS = [
  [0, 0.3, 0, 0.52],
  [-0.42, 0.14, 0.06, 0.36],
  [0.46, 0.16, -0.04, 0.38],
  [-0.76, 0.04, -0.05, 0.22],
  [0.8, 0.05, 0.05, 0.22],
  [0.16, 0.56, 0.04, 0.32],
] as const;
/** How much of its height a heap keeps below its middle. */
const FLATNESS = 0.22;

/** Skins of clouds to smoke from: heaps above, flat below. Every second one is the mirror image of its neighbours. */
export function cumuli(clouds: readonly Cumulus[]): TriangleMesh {
  return merged(
    ...clouds.flatMap(([x, y, z, half], index) =>
      HEAPS.map(([aside, up, ahead, radius]) => {
        const mirrored = index % 2 === 0 ? aside : -aside;
        return placed(flattened(radius * half), { at: [x + mirrored * half, y + up * half, z + ahead * half] });
      }),
    ),
  );
}

function flattened(radius: number): TriangleMesh {
  const { positions, normals, indices } = ballMesh(radius, 8);
  return { positions: positions.map((at, i) => (i % 3 === 1 && at < 0 ? FLATNESS * at : at)), normals, indices };
}
