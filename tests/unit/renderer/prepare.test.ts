import { expect, test } from 'vitest';
import { memoizedCreases, memoizedSeams } from '../../../src/renderer/passes/creases.ts';
import { memoizedExtrusion } from '../../../src/renderer/passes/meshVolumes.ts';
import type { SurfaceDescription } from '../../../src/renderer/passes/surface.ts';
import { preparingSurfaces } from '../../../src/renderer/prepare.ts';
import { ballMesh } from '../../../src/scenes/models/ball.ts';
import { box, ground } from '../../visual/solids.ts';

const [FLOOR, BOX, PLAIN] = [ground(0, 5).mesh, box([0, 0.5, 0], [0.5, 0.5, 0.5]), box([2, 2, 2], [1, 1, 1])];
const color = [0, 0, 0] as const;
const SURFACES: readonly SurfaceDescription[] = [
  { name: 'box', mesh: BOX, color, casts: true, inked: true },
  { name: 'floor', mesh: FLOOR, color, casts: false, inked: true },
  { name: 'plain', mesh: PLAIN, color, casts: true, inked: false },
];

/** Pieces that only look up what is known. */
const [HULLS, VOLUMES, CREASES, SEAMS, VERTICES] = [3, 3, 2, 1, 1];
const LEAST = HULLS + VOLUMES + CREASES + SEAMS + VERTICES;

test('large meshes are processed in more pieces than small ones', () => {
  const piecesFor = (rings: number) => {
    const [one, other] = [0, 1].map(() => ballMesh(1, rings));
    const surfaces = SURFACES.map((surface, index) => ({ ...surface, mesh: [one, other, PLAIN][index] }));
    return [...preparingSurfaces(surfaces)].length;
  };
  const small = piecesFor(6);
  expect(small).toBeLessThan(3 * LEAST);
  // 64 faces of the first ball are compared with the other at a time.
  const faces = ballMesh(1, 60).indices.length / 3;
  expect(piecesFor(60) - small).toBeGreaterThan((0.9 * faces) / 64);
});

test('prepared data is not computed again', () => {
  expect([...preparingSurfaces(SURFACES)].length).toBeGreaterThan(LEAST);
  expect([...preparingSurfaces(SURFACES)]).toHaveLength(LEAST);
  const meshes = [BOX, FLOOR].map((mesh) => structuredClone(mesh.positions));
  // The cached surfaces are independent of later changes of the mesh.
  BOX.positions.fill(0);
  FLOOR.positions.fill(0);
  expect(memoizedExtrusion(BOX).longestEdge).toBeGreaterThan(1);
  expect(memoizedCreases(BOX).count).toBe(12);
  expect(memoizedSeams(BOX)(FLOOR).count).toBeGreaterThan(0);
  [BOX, FLOOR].forEach((mesh, index) => mesh.positions.set(meshes[index]));
});
