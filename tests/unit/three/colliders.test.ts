import {
  Bone,
  BoxGeometry,
  Float32BufferAttribute,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  PlaneGeometry,
  Skeleton,
  SkinnedMesh,
  SphereGeometry,
  TorusGeometry,
  Uint16BufferAttribute,
  Vector3,
} from 'three';
import { beforeAll, expect, test } from 'vitest';
import { ballsOf } from '../../../src/three/proxies.ts';
import { shapeOf } from '../../../src/three/shapes.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { POSE_FLOATS } from '../../../src/simulator/layout.ts';
import { HandledSmoke } from '../../support/handledSmoke.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

let factory: SimulatorFactory;
beforeAll(async () => {
  factory = await loadVariant('physics');
});

const ONE = new Vector3(1, 1, 1);

test('spheres and boxes collide exactly at their scale; stretched spheres and other meshes by their triangles', () => {
  expect(shapeOf(new SphereGeometry(2), new Vector3(3, 3, 3))).toEqual({ type: 'ball', radius: 6 });
  expect(shapeOf(new BoxGeometry(2, 4, 6), new Vector3(1, -2, 3))).toEqual({ type: 'cuboid', halfExtents: [1, 4, 9] });
  expect(shapeOf(new SphereGeometry(2), new Vector3(1, 2, 1)).type).toBe('trimesh');
  expect(shapeOf(new SphereGeometry(2, 8, 8, 0, 3), ONE).type).toBe('trimesh');
  expect(shapeOf(new TorusGeometry(), ONE).type).toBe('trimesh');
});

test.each([
  ['shifted', new BoxGeometry(1, 1, 1).translate(0, 0.5, 0)],
  ['stretched', new BoxGeometry(1, 1, 1).scale(1, 3, 1)],
  ['turned', new BoxGeometry(1, 2, 3, 2, 2, 2).rotateZ(0.4)],
  ['shifted', new SphereGeometry(1, 24, 12).translate(2, 0, 0)],
  ['made smaller', new SphereGeometry(1).scale(0.5, 0.5, 0.5)],
])('a box or sphere that was %s in its local space collides by its triangles', (_, geometry) => {
  const shape = shapeOf(geometry, ONE);
  expect(shape).toMatchObject({ type: 'trimesh', vertices: geometry.attributes.position.array });
});

test('rigids follow the objects, by a fraction of the way in each step', () => {
  const smoke = new HandledSmoke(factory);
  const { simulator } = smoke;
  const carrier = new Group();
  const mesh = new Mesh(new TorusGeometry(0.5, 0.2));
  carrier.add(mesh);
  carrier.position.x = 1;
  smoke.collide(carrier);
  carrier.position.x = 1.2;
  smoke.frame(2);
  const [before, after] = [0, 1].map((blend) => simulator.rigidPoses(blend)[0]);
  expect(before).toBeCloseTo(1.1, 5);
  expect(after).toBeCloseTo(1.2, 5);
  simulator.dispose();
});

test('an instanced mesh has a rigid per instance, a plane is a thin sheet, and objects without a mesh are rejected', () => {
  const smoke = new HandledSmoke(factory);
  const { simulator } = smoke;
  const stones = new InstancedMesh(new BoxGeometry(), undefined, 3);
  for (let index = 0; index < 3; ++index) stones.setMatrixAt(index, new Matrix4().makeTranslation(2 * index, 0, 0));
  smoke.collide(stones);
  smoke.collide(new Mesh(new PlaneGeometry(4, 4)));
  expect(simulator.rigidCount).toBe(4);
  expect(simulator.rigidPoses(1)[2 * POSE_FLOATS]).toBe(4);
  expect(() => smoke.collide(new Group())).toThrow(/collide cannot be “Group”/);
  simulator.dispose();
});

test('balls along a bone fill its skin from end to end and follow it', () => {
  const radius = 0.2;
  const mesh = skinnedBox(radius);
  const before = ballsOf(mesh).map((ballAt) => ({ ...ballAt(), center: ballAt().center.clone() }));
  expect(before.length).toBeGreaterThan(3);
  for (const ball of before) {
    expect(ball.radius).toBeLessThan(Math.SQRT2 * radius);
    expect(Math.abs(ball.center.x) + Math.abs(ball.center.z)).toBeLessThan(1e-6);
  }
  const heights = before.map(({ center }) => center.y);
  expect(Math.min(...heights) - before[0].radius).toBeCloseTo(0, 5);
  expect(Math.max(...heights) + before[0].radius).toBeCloseTo(2, 5);
  mesh.skeleton.bones[0].position.x = 3;
  mesh.updateWorldMatrix(true, true);
  expect(ballsOf(mesh)[0]().center.x).toBeCloseTo(3, 5);
});

function skinnedBox(halfWidth: number): SkinnedMesh {
  const geometry = new BoxGeometry(2 * halfWidth, 2, 2 * halfWidth, 1, 10, 1).translate(0, 1, 0);
  const { count } = geometry.attributes.position;
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(new Uint16Array(4 * count), 4));
  const weights = Array.from({ length: 4 * count }, (_, slot) => (slot % 4 === 0 ? 1 : 0));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
  const mesh = new SkinnedMesh(geometry);
  const bone = new Bone();
  mesh.add(bone);
  mesh.updateWorldMatrix(true, true);
  mesh.bind(new Skeleton([bone]));
  return mesh;
}
