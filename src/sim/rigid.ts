/**
 * Rigids as a caller describes them, and as they cross into WASM.
 */
import { ParameterError } from '../preset/errors.ts';
import { requireIndices } from './indices.ts';
import { poseNumbers, type QuaternionLike, type Triple } from './pose.ts';
import { pathNumbers, spinNumbers, type RigidPath, type RigidSpin } from './rigidPath.ts';

/** A single shape stands around its own origin; capsule and cylinder along y. Lengths in metres. */
export type SingleShape =
  | { type: 'ball'; radius: number }
  | { type: 'cuboid'; halfExtents: Triple }
  /** `halfHeight` is half of the straight part; the caps add `radius` at both ends. */
  | { type: 'capsule'; halfHeight: number; radius: number }
  | { type: 'cylinder'; halfHeight: number; radius: number }
  /** The hull of at least four points that do not lie in one plane; x, y, z each. */
  | { type: 'convexHull'; vertices: ArrayLike<number> }
  /** Triangles, three indices each, counter-clockwise from outside; closed when it should hold smoke out of its inside. */
  | { type: 'trimesh'; vertices: ArrayLike<number>; indices: ArrayLike<number> };

/** A shape of a compound, where it stands in the rigid. */
export interface RigidPart {
  shape: SingleShape;
  /** Metres. */
  position: Triple;
  /** Unit quaternion x, y, z, w; no rotation when left out. */
  rotation?: QuaternionLike;
}

/** One shape, or 1 to 64 of them that move as one. */
export type RigidShape = SingleShape | { type: 'compound'; parts: readonly RigidPart[] };

/** A thing that smoke bumps into. */
export interface RigidDescription {
  /** `fixed` never moves, `kinematic` goes where it is told, `dynamic` falls and is pushed by other rigids. */
  kind: 'fixed' | 'kinematic' | 'dynamic';
  shape: RigidShape;
  /** Metres. */
  position: Triple;
  /** Unit quaternion x, y, z, w; no rotation when left out. */
  rotation?: QuaternionLike;
  /** 0 (default): nothing bounces. 1: particles and rigids keep their speed. */
  restitution?: number;
  /** 0: smooth. 1: what touches it keeps no speed along it. Default 0.5. */
  friction?: number;
  /** kg/m3, default 1000; for dynamic rigids. */
  density?: number;
  /** What becomes of smoke that touches it: it bounces (default), dies, or goes on with a tint. */
  action?: 'bounce' | 'kill' | 'tint';
  /** The tint that it gives, 1 (default) to 15. */
  tint?: number;
  /** Within this distance of the moving surface air is dragged along with it; metres, 0 (default) to 10. */
  boundaryLayer?: number;
  /** How strongly smoke pushes a dynamic rigid: 0 (default) not at all, 1 as air would, up to 10. */
  feelsSmoke?: number;
  /** How a kinematic rigid spins, on top of all else that moves it. */
  spin?: RigidSpin;
  /** Where a kinematic rigid goes by itself; it begins at `position` all the same. */
  path?: RigidPath;
}

/** The arguments of the module's addRigid, in its order; `sim/src/rigids/numbers.rs` tells what they mean. */
export type RigidArguments = [numbers: Float32Array, vertices: Float32Array, indices: Uint32Array, path: Float32Array];

const KINDS: readonly string[] = ['fixed', 'kinematic', 'dynamic'];
const SHAPES: readonly string[] = ['ball', 'cuboid', 'capsule', 'cylinder', 'convexHull', 'trimesh'];
const ACTIONS: readonly string[] = ['bounce', 'kill', 'tint'];
const ORIGIN = [0, 0, 0];

/** @throws ParameterError when the kind or the shape has no such name; numbers are judged by the simulator. */
export function rigidArguments(description: RigidDescription): RigidArguments {
  const { shape } = description;
  const numbers = [
    indexOf(KINDS, 'rigid.kind', description.kind),
    ...poseNumbers(description.position, description.rotation),
    description.restitution ?? 0,
    description.friction ?? 0.5,
    description.density ?? 1000,
    indexOf(ACTIONS, 'rigid.action', description.action ?? 'bounce'),
    description.tint ?? 1,
    description.boundaryLayer ?? 0,
    description.feelsSmoke ?? 0,
    ...spinNumbers(description.spin),
  ];
  const flat: Flat = { numbers, vertices: [], indices: [] };
  if (shape.type === 'compound') {
    requireParts(shape.parts);
    numbers.push(shape.parts.length);
    shape.parts.forEach((part, index) => pushPart(flat, part, `rigid.parts.${index}`));
  } else {
    numbers.push(0);
    pushPart(flat, { shape, position: ORIGIN }, 'rigid');
  }
  return [
    Float32Array.from(numbers),
    Float32Array.from(flat.vertices),
    Uint32Array.from(flat.indices),
    pathNumbers(description.path),
  ];
}

interface Flat {
  numbers: number[];
  vertices: number[];
  indices: number[];
}

function pushPart(flat: Flat, { shape, position, rotation }: RigidPart, name: string): void {
  const dimensions = Array.from(dimensionsOf(shape));
  const vertices = 'vertices' in shape ? shape.vertices : [];
  const indices = shape.type === 'trimesh' ? shape.indices : [];
  requireIndices(indices, name);
  const counts = [dimensions.length, vertices.length, indices.length];
  flat.numbers.push(indexOf(SHAPES, `${name}.shape`, shape.type), ...counts);
  flat.numbers.push(...poseNumbers(position, rotation), ...dimensions);
  for (let index = 0; index < vertices.length; index++) flat.vertices.push(vertices[index]);
  for (let index = 0; index < indices.length; index++) flat.indices.push(indices[index]);
}

/** Zero parts would be read as a single shape. */
function requireParts(parts: readonly RigidPart[]): void {
  if (parts.length < 1 || parts.length > 64) throw new ParameterError('rigid.parts', parts.length, '1 to 64 parts');
}

function indexOf(names: readonly string[], key: string, name: string): number {
  const index = names.indexOf(name);
  if (index < 0) throw new ParameterError(key, name, `one of ${names.join(', ')}`);
  return index;
}

function dimensionsOf(shape: SingleShape): ArrayLike<number> {
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
