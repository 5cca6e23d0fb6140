/** Packs descriptions of rigids for WASM. In a module of its own, because only variants with rigids load it. */
import { ParameterError } from '../base/errors.ts';
import { poseNumbers, requireIndices, type RigidDescription, type RigidPart, type SingleShape } from './rigid.ts';

/** Arguments of the WASM function `addRigid`; `sim-wasm/sim/src/rigids/numbers.rs` documents them. */
export type RigidArguments = [numbers: Float32Array, vertices: Float32Array, indices: Uint32Array];

const KINDS: readonly string[] = ['fixed', 'kinematic', 'dynamic'];
const SHAPES: readonly string[] = ['ball', 'cuboid', 'capsule', 'cylinder', 'convexHull', 'trimesh'];
const ACTIONS: readonly string[] = ['bounce', 'kill', 'tint'];
const ORIGIN = [0, 0, 0];

/** @throws ParameterError for an unknown kind, shape or action. The simulator validates the numbers. */
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
  return [Float32Array.from(numbers), Float32Array.from(flat.vertices), Uint32Array.from(flat.indices)];
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

/** Rejects zero parts, because a count of 0 denotes a single shape. */
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
