import {
  Box3,
  BoxGeometry,
  BufferGeometry,
  CapsuleGeometry,
  Float32BufferAttribute,
  Matrix4,
  Quaternion,
  SphereGeometry,
  Vector3,
  type BatchedMesh,
  type InstancedMesh,
  type LOD,
  type Mesh,
  type MeshStandardMaterial,
  type Object3D,
} from 'three';
import { ParameterError } from '../base/errors.ts';
import type { TriangleMesh } from '../renderer/passes/extrusion.ts';
import type { ColliderShape } from '../simulator/collider.ts';
import type { SingleShape } from '../simulator/rigid.ts';
import { materialsOf } from './relight.ts';

/** World position and rotation. The shape includes the scale. */
export interface Pose {
  position: Vector3;
  rotation: Quaternion;
}

export function newPose(): Pose {
  return { position: new Vector3(), rotation: new Quaternion() };
}

export function copyOf({ position, rotation }: Pose): Pose {
  return { position: position.clone(), rotation: rotation.clone() };
}

const scratch = new Vector3();
const other = new Vector3();

/** Decomposes a world matrix. A pose cannot represent shear, so shear is ignored. */
export function poseOf(world: Matrix4, into: Pose, scale = scratch): Pose {
  world.decompose(into.position, into.rotation, scale);
  return into;
}

export function scaleOf(world: Matrix4): Vector3 {
  const scale = new Vector3();
  world.decompose(new Vector3(), new Quaternion(), scale);
  return scale;
}

/** What a mesh draws at one place: itself or one of its instances. */
export interface DrawnPart {
  geometry: BufferGeometry;
  worldOf: () => Matrix4;
}

/**
 * What a mesh draws now.
 * @throws ParameterError for a mesh without triangles, or one whose shape only its shaders know
 */
export function partsOf(call: string, mesh: Mesh): DrawnPart[] {
  const { geometry, name, type } = mesh;
  const refuse = (accepted: string) => new ParameterError(`${call}.geometry`, name || type, accepted);
  if (((geometry as BufferGeometry | null)?.attributes.position?.count ?? 0) === 0)
    throw refuse('a mesh whose geometry has positions');
  const isMoved = materialsOf(mesh).some((material) => (material as MeshStandardMaterial).displacementMap);
  if ('isInstancedBufferGeometry' in geometry || (mesh as InstancedMesh).morphTexture || isMoved)
    throw refuse('proxies, or a mesh without InstancedBufferGeometry, displacementMap and setMorphAt()');
  const world = new Matrix4();
  const part = (drawn: BufferGeometry, place?: () => void): DrawnPart => ({
    geometry: drawn,
    worldOf: () => {
      mesh.updateWorldMatrix(true, false);
      world.identity();
      place?.();
      return world.premultiply(mesh.matrixWorld);
    },
  });
  let parts = [];
  if ('isBatchedMesh' in mesh) {
    const batch = mesh as BatchedMesh;
    parts = instancesOf(batch).flatMap((id) => {
      if (!batch.getVisibleAt(id)) return [];
      const { start, count } = batch.getGeometryRangeAt(batch.getGeometryIdAt(id));
      return part(drawnGeometry(mesh, start, start + count), () => void batch.getMatrixAt(id, world));
    });
  } else if ('isInstancedMesh' in mesh) {
    const drawn = drawnGeometry(mesh);
    const { count } = mesh as InstancedMesh;
    const each = (index: number) => part(drawn, () => (mesh as InstancedMesh).getMatrixAt(index, world));
    parts = Array.from({ length: count }, (_, index) => each(index));
  } else parts = [part(drawnGeometry(mesh))];
  // Instances are hidden by a scale of 0.
  const isShown = ({ worldOf }: DrawnPart) =>
    !('count' in mesh || 'isBatchedMesh' in mesh) || worldOf().determinant() !== 0;
  parts = parts.filter((each) => each.geometry.attributes.position.count > 0 && isShown(each));
  if (parts.length === 0) throw refuse('a mesh that draws triangles, with a scale above 0');
  return parts;
}

/** Identifiers of the instances of a batch. Those of deleted instances are left out. */
export function instancesOf(batch: BatchedMesh): number[] {
  const ids = [];
  for (let id = 0; ids.length < batch.instanceCount; id++) {
    try {
      batch.getVisibleAt(id);
      ids.push(id);
    } catch {
      continue;
    }
  }
  return ids;
}

/** The meshes of an object; of several levels of detail, the finest. */
export function meshesIn(object: Object3D): Mesh[] {
  const meshes = 'isMesh' in object ? [object as Mesh] : [];
  const coarse = 'isLOD' in object ? (object as LOD).levels.slice(1).map((level) => level.object) : [];
  return meshes.concat(object.children.flatMap((child) => (coarse.includes(child) ? [] : meshesIn(child))));
}

/** The geometry of a mesh if it is drawn as it is, otherwise the triangles between two corners that are drawn, morphed. */
function drawnGeometry(mesh: Mesh, from = 0, to = Infinity): BufferGeometry {
  const { geometry, material, morphTargetInfluences } = mesh;
  const { index, groups, drawRange, attributes, morphAttributes } = geometry;
  const total = index?.count ?? attributes.position.count;
  const ranges = Array.isArray(material)
    ? groups.filter(({ materialIndex }) => material[materialIndex ?? 0]?.visible)
    : [{ start: 0, count: total }];
  const corners = ranges.flatMap(({ start, count }) => {
    const first = Math.max(start, from, drawRange.start);
    const length = Math.min(start + count, to, drawRange.start + drawRange.count, total) - first;
    return Array.from({ length: Math.max(0, length) }, (_, at) => (index ? index.getX(first + at) : first + at));
  });
  const isMorphed = morphAttributes.position && morphTargetInfluences?.some((influence) => influence !== 0);
  if (corners.length === total && !isMorphed) return geometry;
  const positions = corners.flatMap((corner) => mesh.getVertexPosition(corner, scratch).toArray());
  return new BufferGeometry().setAttribute('position', new Float32BufferAttribute(positions, 3));
}

/** The collision shape of a geometry: exact for complete spheres, boxes and capsules, a triangle mesh for everything else. */
export function shapeOf(geometry: BufferGeometry, scale: Vector3): SingleShape {
  const [x, y, z] = [Math.abs(scale.x), Math.abs(scale.y), Math.abs(scale.z)];
  if (isWholeBox(geometry)) {
    const { width, height, depth } = geometry.parameters;
    return { type: 'cuboid', halfExtents: [(width * x) / 2, (height * y) / 2, (depth * z) / 2] };
  }
  if (isWholeSphere(geometry) && isEven(x, y) && isEven(x, z)) {
    return { type: 'ball', radius: geometry.parameters.radius * x };
  }
  if (isWholeCapsule(geometry) && isEven(x, y) && isEven(x, z)) {
    const { radius, height } = geometry.parameters;
    return { type: 'capsule', halfHeight: (height * x) / 2, radius: radius * x };
  }
  const { positions, indices } = trianglesOf(geometry, scale);
  return { type: 'trimesh', vertices: positions, indices };
}

/**
 * The triangles of a geometry at a scale. A mirroring scale reverses the winding, so triangles stay anticlockwise from
 * outside.
 */
export function trianglesOf(geometry: BufferGeometry, scale: Vector3): TriangleMesh {
  const { position } = geometry.attributes;
  const positions = new Float32Array(3 * position.count);
  for (let vertex = 0; vertex < position.count; ++vertex) {
    scratch
      .fromBufferAttribute(position, vertex)
      .multiply(scale)
      .toArray(positions, 3 * vertex);
  }
  const indices = Uint32Array.from(
    geometry.index?.array ?? Array.from({ length: position.count }, (_, index) => index),
  );
  if (scale.x * scale.y * scale.z < 0) {
    for (let corner = 0; corner < indices.length; corner += 3) indices.subarray(corner, corner + 2).reverse();
  }
  return { positions, normals: new Float32Array(positions.length), indices };
}

function isWholeBox(geometry: BufferGeometry): geometry is BoxGeometry {
  if (geometry.type !== 'BoxGeometry') return false;
  const { width, height, depth, widthSegments, heightSegments, depthSegments } = (geometry as BoxGeometry).parameters;
  return isAsMade(geometry, new BoxGeometry(width, height, depth, widthSegments, heightSegments, depthSegments));
}

function isWholeSphere(geometry: BufferGeometry): geometry is SphereGeometry {
  if (geometry.type !== 'SphereGeometry') return false;
  const { radius, widthSegments, heightSegments, phiLength, thetaLength } = (geometry as SphereGeometry).parameters;
  if (phiLength < 2 * Math.PI || thetaLength < Math.PI) return false;
  return isAsMade(geometry, new SphereGeometry(radius, widthSegments, heightSegments));
}

function isWholeCapsule(geometry: BufferGeometry): geometry is CapsuleGeometry {
  if (geometry.type !== 'CapsuleGeometry') return false;
  const { radius, height, capSegments, radialSegments, heightSegments } = (geometry as CapsuleGeometry).parameters;
  const made = new CapsuleGeometry(radius, height, capSegments, radialSegments, heightSegments);
  return height > 0 && isAsMade(geometry, made);
}

/** Whether the vertices are unmodified. Editing a geometry does not change its `parameters`. */
function isAsMade(geometry: BufferGeometry, made: BufferGeometry): boolean {
  const [now, then] = [geometry.attributes.position, made.attributes.position];
  if (now.count !== then.count) return false;
  const tolerance = 1e-4 * radiusOf(made);
  return Array.from({ length: now.count }).every((_, vertex) => {
    scratch.fromBufferAttribute(now, vertex);
    return scratch.distanceTo(other.fromBufferAttribute(then, vertex)) <= tolerance;
  });
}

function radiusOf(geometry: BufferGeometry): number {
  geometry.computeBoundingSphere();
  return geometry.boundingSphere!.radius;
}

function isEven(a: number, b: number): boolean {
  return Math.abs(a - b) <= 1e-4 * a;
}

/** A shape that replaces the meshes of an object. */
export const SURROUNDING = ['ball', 'box', 'capsule', 'plane'] as const;
export type Surrounding = (typeof SURROUNDING)[number];

/** A shape in metres of the smoke, and its pose in the space of an object without its scale, in metres of the world. */
interface PlacedShape extends Pose {
  shape: ColliderShape;
}

/** Shortest length of a shape that the simulator accepts. */
const MIN_LENGTH = 1e-3;

/**
 * The smallest shape of a kind around all meshes of an object as they are drawn now, along the axes of the object. Capsules
 * stand along y and are as high and as wide as the meshes. A plane is their widest side, and what is behind it.
 * @param scale of the smoke
 * @returns undefined without meshes
 */
export function shapeAround(kind: Surrounding, object: Object3D, scale: number): PlacedShape | undefined {
  const box = new Box3();
  forEachPoint(object, (point) => box.expandByPoint(point));
  if (box.isEmpty()) return undefined;
  const position = box.getCenter(new Vector3());
  const rotation = new Quaternion();
  const half = box.getSize(new Vector3()).divideScalar(2);
  if (kind === 'plane') {
    const normal = half.y <= Math.min(half.x, half.z) ? UP : half.z <= half.x ? FORWARD : SIDEWARD;
    rotation.setFromUnitVectors(UP, normal);
    position.addScaledVector(normal, half.dot(normal));
    return { shape: { type: 'plane' }, position, rotation };
  }
  const lengthOf = (length: number) => Math.max(length / scale, MIN_LENGTH);
  if (kind === 'box') {
    return { shape: { type: 'cuboid', halfExtents: half.toArray().map(lengthOf) }, position, rotation };
  }
  let farthest = 0;
  forEachPoint(object, (point) => {
    point.sub(position);
    if (kind === 'capsule') point.y = 0;
    farthest = Math.max(farthest, point.length());
  });
  const radius = lengthOf(farthest);
  const isLong = kind === 'capsule' && half.y > farthest;
  return {
    shape: isLong ? { type: 'capsule', halfHeight: lengthOf(half.y - farthest), radius } : { type: 'ball', radius },
    position,
    rotation,
  };
}

const UP = new Vector3(0, 1, 0);
const FORWARD = new Vector3(0, 0, 1);
const SIDEWARD = new Vector3(1, 0, 0);

/** Visits the vertices of all meshes of an object, in its space without its scale. */
function forEachPoint(object: Object3D, visit: (point: Vector3) => void): void {
  object.updateWorldMatrix(true, true);
  const { position, rotation } = poseOf(object.matrixWorld, newPose());
  const toObject = new Matrix4().compose(position, rotation, ONE).invert();
  const point = new Vector3();
  for (const mesh of meshesIn(object))
    for (const { geometry, worldOf } of partsOf('collide', mesh)) {
      const place = new Matrix4().multiplyMatrices(toObject, worldOf());
      for (let vertex = 0; vertex < geometry.attributes.position.count; vertex++) {
        if ('isSkinnedMesh' in mesh) mesh.getVertexPosition(vertex, point);
        else point.fromBufferAttribute(geometry.attributes.position, vertex);
        visit(point.applyMatrix4(place));
      }
    }
}

const ONE = new Vector3(1, 1, 1);
