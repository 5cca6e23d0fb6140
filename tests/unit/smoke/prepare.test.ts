import { expect, test } from 'vitest';
import { memoizedCreases, memoizedSeams } from '../../../src/passes/creases.ts';
import { memoizedExtrusion } from '../../../src/passes/meshVolumes.ts';
import type { SurfaceDescription } from '../../../src/passes/surface.ts';
import { preparingSurfaces } from '../../../src/smoke/prepare.ts';
import { box, ground } from '../../visual/solids.ts';

const [FLOOR, BOX, PLAIN] = [ground(0, 5).mesh, box([0, 0.5, 0], [0.5, 0.5, 0.5]), box([2, 2, 2], [1, 1, 1])];
const color = [0, 0, 0] as const;
const SURFACES: readonly SurfaceDescription[] = [
  { name: 'box', mesh: BOX, color, casts: true, inked: true },
  { name: 'floor', mesh: FLOOR, color, casts: false, inked: true },
  { name: 'plain', mesh: PLAIN, color, casts: true, inked: false },
];

test('each piece of work processes one mesh or one intersecting pair', () => {
  const pieces = [...preparingSurfaces(SURFACES)];
  const [hulls, volumes, creases, seams] = [3, 3, 2, 1];
  expect(pieces).toHaveLength(hulls + volumes + creases + seams);
});

test('prepared data is not computed again', () => {
  expect([...preparingSurfaces(SURFACES)]).not.toHaveLength(0);
  const meshes = [BOX, FLOOR].map((mesh) => structuredClone(mesh.positions));
  // The cached surfaces are independent of later changes of the mesh.
  BOX.positions.fill(0);
  FLOOR.positions.fill(0);
  expect(memoizedExtrusion(BOX).longestEdge).toBeGreaterThan(1);
  expect(memoizedCreases(BOX).count).toBe(12);
  expect(memoizedSeams(BOX)(FLOOR).count).toBeGreaterThan(0);
  [BOX, FLOOR].forEach((mesh, index) => mesh.positions.set(meshes[index]));
});
