/**
 * Rigids as a caller describes them, and as they cross into WASM.
 */
import { ParameterError } from '../preset/errors.ts';

type Triple = ArrayLike<number>;

/** Shapes stand around their own origin; capsule and cylinder along y. Lengths in metres. */
export type RigidShape =
  | { type: 'ball'; radius: number }
  | { type: 'cuboid'; halfExtents: Triple }
  /** `halfHeight` is half of the straight part; the caps add `radius` at both ends. */
  | { type: 'capsule'; halfHeight: number; radius: number }
  | { type: 'cylinder'; halfHeight: number; radius: number }
  /** The hull of at least four points that do not lie in one plane; x, y, z each. */
  | { type: 'convexHull'; vertices: ArrayLike<number> }
  /** Triangles, three indices each, counter-clockwise from outside; closed when it should hold smoke out of its inside. */
  | { type: 'trimesh'; vertices: ArrayLike<number>; indices: ArrayLike<number> };

/** A thing that smoke bumps into. */
export interface RigidDescription {
  /** `fixed` never moves, `kinematic` goes where it is told, `dynamic` falls and is pushed by other rigids. */
  kind: 'fixed' | 'kinematic' | 'dynamic';
  shape: RigidShape;
  /** Metres. */
  position: Triple;
  /** Unit quaternion x, y, z, w; no rotation when left out. */
  rotation?: ArrayLike<number>;
  /** 0 (default): nothing bounces. 1: particles and rigids keep their speed. */
  restitution?: number;
  /** 0: smooth. 1: what touches it keeps no speed along it. Default 0.5. */
  friction?: number;
  /** kg/m3, default 1000; for dynamic rigids. */
  density?: number;
}

/** The arguments of the module's addRigid, in its order. */
export type RigidArguments = [
  kind: number,
  shape: number,
  dimensions: Float32Array,
  vertices: Float32Array,
  indices: Uint32Array,
  pose: Float32Array,
  restitution: number,
  friction: number,
  density: number,
];

const KINDS: readonly string[] = ['fixed', 'kinematic', 'dynamic'];
const SHAPES: readonly string[] = ['ball', 'cuboid', 'capsule', 'cylinder', 'convexHull', 'trimesh'];
const NO_ROTATION = [0, 0, 0, 1];

/** @throws ParameterError when the kind or the shape has no such name; numbers are judged by the simulator. */
export function rigidArguments(description: RigidDescription): RigidArguments {
  const { shape } = description;
  const mesh = 'vertices' in shape ? shape.vertices : [];
  return [
    indexOf(KINDS, 'rigid.kind', description.kind),
    indexOf(SHAPES, 'rigid.shape', shape.type),
    Float32Array.from(dimensionsOf(shape)),
    Float32Array.from(mesh),
    indicesOf(shape),
    poseOf(description.position, description.rotation),
    description.restitution ?? 0,
    description.friction ?? 0.5,
    description.density ?? 1000,
  ];
}

/** Position and rotation as the seven floats of a pose. */
export function poseOf(position: Triple, rotation: ArrayLike<number> = NO_ROTATION): Float32Array {
  return Float32Array.of(position[0], position[1], position[2], rotation[0], rotation[1], rotation[2], rotation[3]);
}

function indexOf(names: readonly string[], key: string, name: string): number {
  const index = names.indexOf(name);
  if (index < 0) throw new ParameterError(key, name, `one of ${names.join(', ')}`);
  return index;
}

function dimensionsOf(shape: RigidShape): ArrayLike<number> {
  switch (shape.type) {
    case 'ball':
      return [shape.radius];
    case 'cuboid':
      return shape.halfExtents;
    case 'capsule':
    case 'cylinder':
      return [shape.halfHeight, shape.radius];
    default:
      return [];
  }
}

/** A typed array would wrap an index such as -1 into one that may exist; such an index is refused here. */
function indicesOf(shape: RigidShape): Uint32Array {
  if (shape.type !== 'trimesh') return new Uint32Array();
  for (let index = 0; index < shape.indices.length; index++) {
    const vertex = shape.indices[index];
    if (!Number.isInteger(vertex) || vertex < 0 || vertex > 0xffffffff) {
      throw new ParameterError(`rigid.indices.${index}`, vertex, 'the number of a vertex');
    }
  }
  return Uint32Array.from(shape.indices);
}
