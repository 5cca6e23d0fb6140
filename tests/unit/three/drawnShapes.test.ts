import {
  BatchedMesh,
  Box3,
  BoxGeometry,
  BufferAttribute,
  CylinderGeometry,
  Group,
  InstancedBufferGeometry,
  InstancedMesh,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Line,
  LOD,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  Points,
  Sprite,
  Texture,
  Vector3,
  type BufferGeometry,
  type Object3D,
} from 'three';
import { expect, test } from 'vitest';
import { instanceBalls } from '../../../src/three/proxies.ts';
import { meshesIn, partsOf, shapeOf } from '../../../src/three/shapes.ts';

const material = new MeshBasicMaterial();
const hidden = new MeshBasicMaterial({ visible: false });
const box = (x = 0) => new BoxGeometry(1, 1, 1).translate(x, 0, 0);
const at = (x: number, scale = 1) => new Matrix4().makeScale(scale, scale, scale).setPosition(x, 0, 0);

/** The ends along x of what an object's meshes collide as. */
function extent(object: Object3D): number[] {
  object.updateMatrixWorld(true);
  const all = new Box3();
  for (const mesh of meshesIn(object))
    for (const { geometry, worldOf } of partsOf('collide', mesh)) {
      const shape = shapeOf(geometry, new Vector3(1, 1, 1));
      const { position } = geometry.attributes;
      const vertices = shape.type === 'trimesh' ? new BufferAttribute(shape.vertices as Float32Array, 3) : position;
      for (let vertex = 0; vertex < vertices.count; vertex++)
        all.expandByPoint(new Vector3().fromBufferAttribute(vertices, vertex).applyMatrix4(worldOf()));
    }
  return [all.min.x, all.max.x].map((end) => Number(end.toFixed(3)));
}

function batch(): BatchedMesh {
  const mesh = new BatchedMesh(6, 200, 400, material);
  const [small, tall] = [mesh.addGeometry(box()), mesh.addGeometry(new CylinderGeometry(0.5, 0.5, 2, 8))];
  const ids = [small, tall, small, small].map((geometry, index) => {
    const id = mesh.addInstance(geometry);
    mesh.setMatrixAt(id, at(4 * index));
    return id;
  });
  mesh.setVisibleAt(ids[3], false);
  mesh.deleteInstance(ids[0]);
  return mesh;
}

function instanced(): InstancedMesh {
  const mesh = new InstancedMesh(box(), material, 5);
  [at(0), at(3), at(9, 0), at(-2), at(50)].forEach((matrix, index) => mesh.setMatrixAt(index, matrix));
  mesh.count = 4;
  return mesh;
}

function morphed(isRelative: boolean): Mesh {
  const geometry = box();
  const target = box(isRelative ? 0 : 6).attributes.position;
  if (isRelative) for (let vertex = 0; vertex < target.count; vertex++) target.setXYZ(vertex, 6, 0, 0);
  geometry.morphAttributes.position = [target];
  geometry.morphTargetsRelative = isRelative;
  const mesh = new Mesh(geometry, material);
  mesh.morphTargetInfluences = [0.5];
  return mesh;
}

/** Two boxes in one geometry. */
function twoBoxes(): BufferGeometry {
  const soup = box().toNonIndexed();
  const other = box(6).toNonIndexed();
  const both = new Float32Array([...soup.attributes.position.array, ...other.attributes.position.array]);
  return soup.setAttribute('position', new BufferAttribute(both, 3));
}

function ranged(count = 36): Mesh {
  const geometry = twoBoxes();
  geometry.setDrawRange(36, count);
  return new Mesh(geometry, material);
}

function grouped(materials: MeshBasicMaterial[]): Mesh {
  const geometry = twoBoxes();
  geometry.clearGroups();
  geometry.addGroup(0, 36, 0);
  geometry.addGroup(36, 36, 1);
  return new Mesh(geometry, materials);
}

function quantised(): Mesh {
  const geometry = box();
  const places = Int16Array.from(geometry.attributes.position.array, (each) => Math.round(each * 32767));
  geometry.setAttribute('position', new BufferAttribute(places, 3, true));
  return new Mesh(geometry, material);
}

function interleaved(): Mesh {
  const geometry = box();
  const { array, count } = geometry.attributes.position;
  const wide = new Float32Array(5 * count);
  for (let vertex = 0; vertex < count; vertex++) wide.set(array.slice(3 * vertex, 3 * vertex + 3), 5 * vertex);
  geometry.setAttribute('position', new InterleavedBufferAttribute(new InterleavedBuffer(wide, 5), 3, 0));
  return new Mesh(geometry, material);
}

function levels(): LOD {
  return new LOD().addLevel(new Mesh(box(), material), 0).addLevel(new Mesh(box(7), material), 10);
}

test.each([
  ['instances of a batch, without hidden and deleted ones', batch, [3.5, 8.5]],
  ['instances up to the count, without those of scale 0', instanced, [-2.5, 3.5]],
  ['morph targets', () => morphed(false), [2.5, 3.5]],
  ['relative morph targets', () => morphed(true), [2.5, 3.5]],
  ['the range that is drawn', () => ranged(), [5.5, 6.5]],
  ['groups with materials', () => grouped([material, material]), [-0.5, 6.5]],
  ['groups without a visible material', () => grouped([hidden, material]), [5.5, 6.5]],
  ['groups without a material', () => grouped([material]), [-0.5, 0.5]],
  ['an invisible mesh', () => Object.assign(new Mesh(box(), hidden), { visible: false }), [-0.5, 0.5]],
  ['no index', () => new Mesh(box().toNonIndexed(), material), [-0.5, 0.5]],
  ['normalised integers', quantised, [-0.5, 0.5]],
  ['interleaved attributes', interleaved, [-0.5, 0.5]],
  ['the finest level of detail', levels, [-0.5, 0.5]],
  [
    'a group with a line and a sprite, which have no surface',
    () => new Group().add(new Mesh(box(2), material), new Line(box(9)), new Sprite()),
    [1.5, 2.5],
  ],
] as const)('collide and cast take the shape as it is drawn: %s', (_, make, ends) => {
  expect(extent(make())).toEqual(ends);
});

test.each([
  [
    'an instanced geometry, as of fat lines',
    () => new Mesh(new InstancedBufferGeometry().copy(box() as never), material),
  ],
  ['a displacement map', () => new Mesh(box(), new MeshStandardMaterial({ displacementMap: new Texture() }))],
  ['instances of scale 0', () => Object.assign(instanced(), { count: 0 })],
  ['nothing in the range', () => ranged(0)],
  ['instances with morph targets', () => Object.assign(instanced(), { morphTexture: new Texture() })],
] as const)('collide and cast refuse by name: %s', (_, make) => {
  const mesh = Object.assign(make(), { name: 'wrong one' });
  expect(() => partsOf('cast', mesh as Mesh)).toThrow(/cast\.geometry cannot be “wrong one”/);
});

test('points, lines and sprites alone have no mesh', () => {
  for (const object of [new Points(box()), new Line(box()), new Sprite()]) expect(meshesIn(object)).toEqual([]);
});

test('balls of instances follow the count, and of a batch what is visible', () => {
  const mesh = instanced();
  mesh.updateMatrixWorld(true);
  const balls = instanceBalls(mesh);
  expect(balls.map((ball) => ball().radius > 0)).toEqual([true, true, false, true]);
  mesh.count = 1;
  expect(balls.map((ball) => ball().radius > 0)).toEqual([true, false, false, false]);
  const batched = batch();
  batched.updateMatrixWorld(true);
  const ofBatch = instanceBalls(batched);
  expect(ofBatch.map((ball) => ball().radius > 0)).toEqual([true, true, false]);
  expect(ofBatch[0]().center.x).toBe(4);
  batched.deleteInstance(1);
  expect(ofBatch[0]().radius).toBe(0);
});
