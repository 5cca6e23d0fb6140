import {
  Bone,
  BoxGeometry,
  CapsuleGeometry,
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
import type { CollideOptions } from '../../../src/three/colliders.ts';
import { shapeAround, shapeOf, type Surrounding } from '../../../src/three/shapes.ts';
import { COLLIDER_LIMIT, type ColliderShape } from '../../../src/simulator/collider.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { POSE_FLOATS } from '../../../src/simulator/layout.ts';
import { HandledSmoke, STILL } from '../../support/handledSmoke.ts';
import { JET, loadVariant } from '../../support/sim/simWasm.ts';

let factory: SimulatorFactory;
let core: SimulatorFactory;
let meshes: SimulatorFactory;
beforeAll(async () => {
  [factory, core, meshes] = await Promise.all([loadVariant('physics'), loadVariant('core'), loadVariant('meshes')]);
});

const ONE = new Vector3(1, 1, 1);

test('spheres, boxes and capsules collide exactly at their scale; stretched ones and other meshes by their triangles', () => {
  const capsule = { type: 'capsule', halfHeight: 3, radius: 2 };
  expect(shapeOf(new CapsuleGeometry(1, 3), new Vector3(2, 2, 2))).toEqual(capsule);
  expect(shapeOf(new CapsuleGeometry(1, 3), new Vector3(1, 2, 1)).type).toBe('trimesh');
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

/** A smoke with a puff at rest at each place. */
function puffsAt(factoryOfSmoke: SimulatorFactory, places: readonly [number, number, number][]): HandledSmoke {
  const smoke = new HandledSmoke(factoryOfSmoke, STILL);
  for (const [x, y, z] of places) {
    const source = smoke.put(new Group());
    source.position.set(x, y, z);
    void smoke.emitFrom(source, { rate: 0, speed: 0, shape: 'point', size: 0.2 }).burst(1);
  }
  smoke.frame();
  return smoke;
}

test.each([
  ['ball', new SphereGeometry(0.5)],
  ['box', new BoxGeometry(1, 0.8, 0.6)],
  ['capsule', new CapsuleGeometry(0.3, 0.6)],
])('a %s moves the same smoke by the core and by physics', (_, geometry) => {
  const [own, rapier] = [core, factory].map((variant) => {
    const smoke = puffsAt(variant, [
      [1, 0.1, 0],
      [1.6, -0.1, 0.1],
      [2.2, 0.3, 0.2],
    ]);
    const mesh = smoke.put(new Mesh(geometry));
    smoke.collide(mesh, { restitution: 0.3 });
    expect(smoke.simulator.hasRigids).toBe(variant === factory);
    for (let frame = 1; frame <= 30; frame++) {
      mesh.position.x = 0.08 * frame;
      mesh.rotation.set(0.1 * frame, 0.05 * frame, 0);
      smoke.frame(2);
    }
    const places = smoke.places().flat();
    expect([smoke.needs, smoke.errors]).toEqual([[], []]);
    smoke.simulator.dispose();
    return places;
  });
  expect(Math.max(...own.filter((_place, at) => at % 3 === 0))).toBeGreaterThan(2.5);
  own.forEach((place, at) => expect(Math.abs(place - rapier[at])).toBeLessThan(1e-3));
});

test('a removed or disabled collider of the core leaves nothing, and its place is free again', () => {
  const smoke = new HandledSmoke(core);
  const still = smoke.simulator.hash();
  const balls = Array.from({ length: COLLIDER_LIMIT }, () => new Mesh(new SphereGeometry(0.1)));
  const handles = balls.map((ball) => smoke.collide(ball));
  expect(smoke.needs).toEqual([]);
  smoke.collide(new Mesh(new SphereGeometry(0.1))).remove();
  expect(smoke.needs).toEqual(['meshes']);
  handles[7].remove();
  smoke.collide(balls[7], { action: 'kill' });
  expect(smoke.needs).toEqual(['meshes']);
  const before = smoke.simulator.hash();
  smoke.simulator.restore(smoke.simulator.save(), false);
  expect(smoke.simulator.hash()).toBe(still);
  expect(before).not.toBe(still);
  smoke.simulator.dispose();
});

/** A mesh of triangles that turns and moves to and fro for 5 s through a jet, and jumps once a second. */
function jetPast(variant: SimulatorFactory, mesh: Mesh, options: CollideOptions): [places: number[], hash: string] {
  const smoke = new HandledSmoke(variant, { ...JET, 'emission.rate': 200, 'turbulence.speed': 0.4 }, 1000);
  const { simulator } = smoke;
  const place = (step: number) => {
    mesh.position.set(0.4 * Math.sin(step / 20) + (step % 60 > 55 ? 4 : 0), 1.2, 0.1 * Math.cos(step / 30));
    mesh.rotation.set(0.05 * step, 0.3, 0.02 * step);
  };
  smoke.put(mesh);
  place(0);
  smoke.collide(mesh, options);
  for (let step = 1; step <= 300; step++) {
    place(step);
    smoke.frame();
  }
  const places = smoke.places().flat();
  expect([simulator.hasRigids, simulator.rigidCount, smoke.needs, smoke.errors]).toEqual([true, 1, [], []]);
  simulator.restore(simulator.save(), false);
  const hash = simulator.hash();
  simulator.dispose();
  return [places, hash];
}

test.each<[string, Mesh, CollideOptions]>([
  ['closed mesh', new Mesh(new TorusGeometry(0.5, 0.2)), { restitution: 0.3 }],
  ['sheet', new Mesh(new PlaneGeometry(1, 1)), { friction: 0 }],
  ['mesh with a boundary layer', new Mesh(new TorusGeometry(0.5, 0.2)), { boundaryLayer: 0.3 }],
  ['mesh that kills', new Mesh(new TorusGeometry(0.5, 0.2)), { action: 'kill' }],
])('a %s moves the same smoke without Rapier, to the last bit', (_, mesh, options) => {
  const [own, ownHash] = jetPast(meshes, mesh, options);
  const [rapier, rapierHash] = jetPast(factory, mesh, options);
  expect(own).toEqual(rapier);
  expect(ownHash).toBe(rapierHash);
  expect(own).not.toEqual(jetPast(meshes, new Mesh(new SphereGeometry(0.01)), options)[0]);
});

test('meshes go on after a restored state, and as kinematic rigids of physics, which has all of them', () => {
  const smoke = new HandledSmoke(meshes, JET, 1000);
  const { simulator } = smoke;
  const torus = smoke.put(new Mesh(new TorusGeometry(0.5, 0.2)));
  const others = [1, 2].map((x) => smoke.collide(smoke.put(new Mesh(new PlaneGeometry(1, 1)), x)));
  smoke.collide(torus);
  const turn = (frames: number) => {
    for (let frame = 0; frame < frames; frame++) {
      torus.position.y += 0.02;
      torus.rotation.x += 0.1;
      smoke.frame();
    }
  };
  turn(30);
  others[0].remove();
  turn(5);
  const [saved, hash] = [simulator.save(), simulator.hash()];
  turn(20);
  const later = simulator.hash();
  simulator.restore(saved);
  expect([simulator.hash(), simulator.rigidCount]).toEqual([hash, 3]);
  torus.position.y -= 0.4;
  torus.rotation.x -= 2;
  smoke.frame();
  expect(simulator.hash()).not.toBe(later);
  simulator.restore(saved);
  const poses = Array.from(simulator.rigidPoses(0.5));
  simulator.moveTo(factory.module);
  expect([simulator.hasDynamics, simulator.rigidCount]).toEqual([true, 3]);
  expect(Array.from(simulator.rigidPoses(0.5))).toEqual(poses);
  const lantern = smoke.put(new Mesh(new SphereGeometry(0.3)), 5);
  smoke.collide(lantern, { feelsSmoke: true });
  turn(60);
  // It has the place of the one that was removed, and falls.
  expect(simulator.rigidCount).toBe(3);
  expect(lantern.position.y).toBeLessThan(-3);
  expect(simulator.rigidPoses(1)[2 * POSE_FLOATS + 1]).toBeCloseTo(torus.position.y, 5);
  // A state with what only Rapier can move, without it.
  const other = meshes.create({ capacity: 1000, seed: 7 });
  expect(() => other.restore(simulator.save())).toThrow(/physics/);
  other.restore(simulator.save(), false);
  expect([other.rigidCount, other.alive]).toEqual([0, simulator.alive]);
  expect([smoke.needs, smoke.errors]).toEqual([[], []]);
  other.dispose();
  simulator.dispose();
});

test.each<[string, Mesh, CollideOptions]>([
  ['another mesh', new Mesh(new TorusGeometry(0.5, 0.2)), {}],
  ['a stretched sphere', new Mesh(new SphereGeometry(0.5).scale(1, 2, 1)), {}],
  ['a boundary layer', new Mesh(new SphereGeometry(0.5)), { boundaryLayer: 0.2 }],
  ['a push by smoke', new Mesh(new SphereGeometry(0.5)), { feelsSmoke: true }],
])('%s waits for rigids, which take the other colliders along', (_, mesh, options) => {
  const wanted = options.feelsSmoke ? 'physics' : 'meshes';
  const smoke = new HandledSmoke(core);
  const { simulator } = smoke;
  const floor = smoke.put(new Mesh(new PlaneGeometry(4, 4).rotateX(-Math.PI / 2)));
  smoke.collide(floor, { shape: 'plane' });
  smoke.put(mesh).position.y = 3;
  smoke.collide(mesh, options);
  expect(smoke.needs).toEqual([wanted]);
  smoke.frames(3);
  expect([simulator.rigidCount, simulator.steps, mesh.position.y]).toEqual([0, 3, 3]);
  const hash = simulator.hash();
  simulator.moveTo((options.feelsSmoke ? factory : meshes).module);
  expect([simulator.hasRigids, simulator.steps, simulator.hash()]).toEqual([true, 3, hash]);
  smoke.frames(120);
  expect(simulator.rigidCount).toBe(2);
  // The top of the slab is the plane.
  if (options.feelsSmoke) expect(mesh.position.y).toBeCloseTo(0.5, 2);
  expect(smoke.errors).toEqual([]);
  simulator.dispose();
});

test('one shape around all meshes of an object, at its scale', () => {
  const group = new Group();
  const [left, right] = [-1, 1].map((x) => new Mesh(new BoxGeometry(1, 3, 1).translate(x, 0.5, 0)));
  group.add(left, right);
  group.scale.setScalar(2);
  group.rotation.y = 0.5;
  const around = (kind: Surrounding, scale = 1) => shapeAround(kind, group, scale)!;
  expect(around('box').shape).toMatchObject({ type: 'cuboid' });
  const box = around('box', 2);
  const { halfExtents } = box.shape as Extract<ColliderShape, { type: 'cuboid' }>;
  [1.5, 1.5, 0.5].forEach((half, axis) => expect(halfExtents[axis]).toBeCloseTo(half));
  expect(box.position.distanceTo(new Vector3(0, 1, 0))).toBeLessThan(1e-6);
  const ball = around('ball').shape as Extract<ColliderShape, { type: 'ball' }>;
  expect(ball.radius).toBeCloseTo(Math.hypot(3, 3, 1));
  // As wide as it is high, so that nothing of a capsule is straight.
  expect(around('capsule').shape.type).toBe('ball');
  group.remove(right);
  const capsule = around('capsule').shape as Extract<ColliderShape, { type: 'capsule' }>;
  expect([capsule.radius, capsule.halfHeight + capsule.radius].map((length) => length.toFixed(3))).toEqual([
    Math.SQRT2.toFixed(3),
    '3.000',
  ]);
});

test('a plane is the widest side of a mesh', () => {
  for (const geometry of [new BoxGeometry(4, 0.2, 3), new PlaneGeometry(4, 3), new BoxGeometry(0.2, 4, 3)]) {
    const { position, rotation, shape } = shapeAround('plane', new Mesh(geometry), 1)!;
    const normal = new Vector3(0, 1, 0).applyQuaternion(rotation);
    geometry.computeBoundingBox();
    const { max } = geometry.boundingBox!;
    expect(shape).toEqual({ type: 'plane' });
    expect(position.dot(normal)).toBeCloseTo(max.dot(normal));
    expect(max.dot(normal)).toBeLessThan(0.2);
  }
});

test.each<[CollideOptions, RegExp]>([
  [{ shape: 'cone' as never }, /collide\.shape cannot be “cone”/],
  [{ shape: 'ball', feelsSmoke: true }, /collide\.shape/],
  [{ restitution: 1.5 }, /collide\.restitution cannot be/],
  [{ action: 'burn' as never }, /collide\.action cannot be/],
  [{ tint: 0 }, /collide\.tint cannot be/],
  [{ boundaryLayer: 11 }, /collide\.boundaryLayer cannot be/],
  [{ density: 0, feelsSmoke: true }, /collide\.density cannot be/],
])('the option %o is an error of the call, before rigids are loaded', (options, message) => {
  const smoke = new HandledSmoke(core);
  expect(() => smoke.collide(new Mesh(new TorusGeometry()), options)).toThrow(message);
  expect(() => smoke.collide(new Mesh(new SphereGeometry(2e3)))).toThrow(/collide\.shape cannot be/);
  expect(smoke.needs).toEqual([]);
  smoke.simulator.dispose();
});
