import { expect, test } from 'vitest';
import { ShapeError } from '../../../../src/base/errors.ts';
import { BallCover } from '../../../../src/renderer/puffs/fit/ballCover.ts';
import { closedMesh, MAX_TRIANGLES, type PlainMesh } from '../../../../src/renderer/puffs/fit/closedMesh.ts';
import { requireShapes } from '../../../../src/renderer/puffs/lobes.ts';
import { fitPuff } from '../../../../src/renderer/puffs/fit/fitPuff.ts';
import { reachOf } from '../../../../src/renderer/puffs/lobes.ts';
import { LOBE_SHAPES } from '../../../../src/renderer/puffs/lobeShapes.ts';
import { puffMesh } from '../../../../src/renderer/puffs/billboards/mesh.ts';
import type { Lobe } from '../../../../src/renderer/puffs/shapes.ts';
import { centreOf, depthsOf, voxelsOf } from '../../../../src/renderer/puffs/fit/voxels.ts';
import { box } from '../../../visual/solids.ts';

const BALL: Lobe = { center: [0, 0, 0], radius: 1 };
const ball = puffMesh([BALL]);

test('voxels have their centres in a ball, and store their depth', () => {
  const voxels = voxelsOf(closedMesh(ball), 32);
  const depths = depthsOf(voxels);
  let wrong = 0;
  voxels.inside.forEach((value, voxel) => {
    const [x, y, z] = [voxel % 32, Math.floor(voxel / 32) % 32, Math.floor(voxel / 1024)].map((at) =>
      centreOf(at, voxels.width),
    );
    const distance = 1 - Math.hypot(x, y, z);
    // The facets of the mesh are slightly inside the ball.
    if (Math.abs(distance) > 0.01 && value !== (distance > 0 ? 1 : 0)) wrong++;
    if (value === 1) expect(Math.abs(depths[voxel] - distance)).toBeLessThan(voxels.width);
  });
  expect(wrong).toBe(0);
});

test('the union of overlapping closed parts is inside, for either winding', () => {
  const parts = puffMesh([
    { center: [-0.4, 0, 0], radius: 0.5 },
    { center: [0.3, 0.1, 0], radius: 0.6 },
  ]);
  const voxels = voxelsOf(closedMesh(parts), 40);
  const inverted = voxelsOf(closedMesh({ ...parts, indices: parts.indices.toReversed() }), 40);
  expect(inverted.inside).toEqual(voxels.inside);
  // Its bounding box has the centre (0, 0.1, 0); the farthest point belongs to the first ball.
  const reach = Math.hypot(0.4, 0.1) + 0.5;
  const balls: Lobe[] = [
    { center: [-0.4 / reach, -0.1 / reach, 0], radius: 0.5 / reach },
    { center: [0.3 / reach, 0, 0], radius: 0.6 / reach },
  ];
  expect(new BallCover(voxels, balls).overlap).toBeGreaterThan(0.97);
});

test('a ball needs one lobe at any position and size', async () => {
  const { shape, overlap } = await fitPuff(ball);
  expect(shape.lobes).toHaveLength(1);
  expect(shape.lobes[0].radius).toBeCloseTo(1, 2);
  expect(overlap).toBeGreaterThan(0.97);
  const moved = { ...ball, positions: ball.positions.map((at, index) => 40 * at + [5, -90, 3][index % 3]) };
  const other = await fitPuff(moved);
  expect(other.shape.lobes[0].radius).toBeCloseTo(shape.lobes[0].radius, 2);
});

test('a puff of lobes is mostly recovered; fewer lobes recover less', async () => {
  const mesh = puffMesh(LOBE_SHAPES[1].lobes);
  const [whole, rough] = [await fitPuff(mesh, { name: 'again' }), await fitPuff(mesh, { lobes: 3 })];
  console.log(`overlap with 12 lobes ${whole.overlap.toFixed(3)}, with 3 ${rough.overlap.toFixed(3)}`);
  expect(whole.shape.name).toBe('again');
  expect(whole.overlap).toBeGreaterThan(0.9);
  expect(rough.overlap).toBeLessThan(whole.overlap);
  expect(rough.shape.lobes).toHaveLength(3);
  expect(reachOf(whole.shape.lobes)).toBeGreaterThan(0.98);
  expect(() => requireShapes([whole.shape, rough.shape])).not.toThrow();
});

test('a box with separate vertices for each normal is closed, and becomes a puff', async () => {
  const { overlap } = await fitPuff(box([3, 4, 5], [1, 1, 1]));
  expect(overlap).toBeGreaterThan(0.75);
});

const cases: readonly (readonly [string, PlainMesh, RegExp])[] = [
  ['empty', { positions: [], indices: [] }, /empty/],
  ['cut short', { positions: [0, 0, 0, 1], indices: [0, 0, 0] }, /incomplete/],
  [
    'not finite',
    { ...ball, positions: ball.positions.map((at, index) => (index === 6 ? NaN : at)) },
    /Vertex 2 .* NaN/,
  ],
  [
    'pointing outside',
    { positions: ball.positions, indices: [0, 1, 100000] },
    /uses vertex 100000, which does not exist/,
  ],
  ['open', { positions: ball.positions, indices: ball.indices.subarray(3) }, /open: 3 of its/],
  ['of one point', { positions: [1, 1, 1], indices: [0, 0, 0] }, /no size/],
  ['flat', box([0, 0, 0], [1, 1, 0.001]), /too thin/],
  ['short of normals', { ...ball, normals: [0, 0, 1] }, /3 finite numbers in normals/],
  ['coloured by no number', { ...ball, colors: ball.positions.map(() => NaN) }, /3 finite numbers in colors/],
  ['textured without uvs', { ...ball, texture: { width: 1, height: 1, data: new Uint8Array(4) } }, /no uvs/],
  ['textured by too few pixels', textured(2, 2, 12), /has 12 bytes; 2 x 2 pixels need 16/],
  ['too large', { positions: ball.positions, indices: new Uint32Array(3 * MAX_TRIANGLES + 3) }, /250001 triangles/],
];

function textured(width: number, height: number, bytes: number): PlainMesh {
  const uvs = new Float32Array((ball.positions.length / 3) * 2);
  return { ...ball, uvs, texture: { width, height, data: new Uint8Array(bytes) } };
}

test.each(cases)('a mesh that is %s is rejected with a message', async (_, mesh, message) => {
  const rejected = fitPuff(mesh);
  await expect(rejected).rejects.toThrow(ShapeError);
  await expect(rejected).rejects.toThrow(message);
});

test('fitting can be aborted', async () => {
  const controller = new AbortController();
  const fitting = fitPuff(box([0, 0, 0], [1, 1, 1]), { signal: controller.signal });
  controller.abort(new Error('enough'));
  await expect(fitting).rejects.toThrow('enough');
});

test('invalid puff shapes are rejected with a message', () => {
  const shape = (lobes: readonly Lobe[]) => [{ name: 'odd', lobes }];
  expect(() => requireShapes([])).toThrow(/0 puff shapes/);
  expect(() => requireShapes(shape([]))).toThrow(/odd has 0 lobes/);
  expect(() => requireShapes(shape([{ center: [0.5, 0, 0], radius: 0.8 }]))).toThrow(/unit ball/);
  expect(() => requireShapes(shape([{ center: [NaN, 0, 0], radius: 0.8 }]))).toThrow(/unit ball/);
  expect(() => requireShapes(shape([{ center: [0, 0, 0], radius: 0 }]))).toThrow(/radii must be above 0/);
});
