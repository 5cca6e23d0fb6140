import { BoxGeometry, Quaternion, SphereGeometry, Vector3, type BufferGeometry, type Matrix4, type Mesh } from 'three';
import { ParameterError } from '../preset/errors.ts';
import type { TriangleMesh } from '../passes/extrusion.ts';
import type { SingleShape } from '../sim/rigid.ts';

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

/** @throws ParameterError for a mesh without vertices */
export function requireGeometry(call: string, { geometry, name, type }: Mesh): void {
  if (((geometry as BufferGeometry | null)?.attributes.position?.count ?? 0) > 0) return;
  throw new ParameterError(`${call}.geometry`, name || type, 'a mesh whose geometry has positions');
}

/** The collision shape of a geometry: exact for complete spheres and boxes, a triangle mesh for everything else. */
export function shapeOf(geometry: BufferGeometry, scale: Vector3): SingleShape {
  const [x, y, z] = [Math.abs(scale.x), Math.abs(scale.y), Math.abs(scale.z)];
  if (isWholeBox(geometry)) {
    const { width, height, depth } = geometry.parameters;
    return { type: 'cuboid', halfExtents: [(width * x) / 2, (height * y) / 2, (depth * z) / 2] };
  }
  if (isWholeSphere(geometry) && isEven(x, y) && isEven(x, z)) {
    return { type: 'ball', radius: geometry.parameters.radius * x };
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
