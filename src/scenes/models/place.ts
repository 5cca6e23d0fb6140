import { inOne, type TriangleMesh } from '../../renderer/passes/extrusion.ts';
import { rotate, quaternionFromAngles } from '../../simulator/exact/rotation.ts';
import type { Placement, Vector } from '../scene.ts';
import { normalized } from './revolve.ts';

/** The transform of a mesh: scale, then rotation, then translation. */
export interface Stand {
  readonly at?: Vector;
  /** Radians about x, then y, then z, each about the world axis. */
  readonly angles?: Vector;
  /** Along each local axis; above 0. */
  readonly scale?: Vector | number;
}

/** The transformed mesh, with unit normals. */
export function placed(
  { positions, normals, indices, coarser }: TriangleMesh,
  { at = [0, 0, 0], angles = [0, 0, 0], scale = 1 }: Stand,
): TriangleMesh {
  const [a, b, c] = typeof scale === 'number' ? [scale, scale, scale] : scale;
  const rotation = quaternionFromAngles(angles);
  return {
    positions: mapped(positions, (x, y, z) =>
      rotate(rotation, [a * x, b * y, c * z]).map((along, axis) => along + at[axis]),
    ),
    normals: mapped(normals, (x, y, z) => normalized(rotate(rotation, [x / a, y / b, z / c]))),
    indices,
    coarser: coarser && ((deviation) => coarser(deviation / Math.max(a, b, c))),
  };
}

/** Merges several meshes into one. */
export function merged(...meshes: readonly TriangleMesh[]): TriangleMesh {
  const together = (indicesOf: (mesh: TriangleMesh) => Uint32Array): Uint32Array => {
    const all: number[] = [];
    let first = 0;
    for (const mesh of meshes) {
      for (const index of indicesOf(mesh)) all.push(first + index);
      first += mesh.positions.length / 3;
    }
    return new Uint32Array(all);
  };
  return {
    positions: inOne(meshes.map(({ positions }) => positions)),
    normals: inOne(meshes.map(({ normals }) => normals)),
    indices: together(({ indices }) => indices),
    coarser: (deviation) => together((mesh) => mesh.coarser?.(deviation) ?? mesh.indices),
  };
}

/** A placement with defaults: the origin, without rotation. */
export function placement(position: Vector = [0, 0, 0], angles: Vector = [0, 0, 0]): Placement {
  return { position, rotation: quaternionFromAngles(angles) };
}

function mapped(triples: Float32Array, map: (x: number, y: number, z: number) => readonly number[]): Float32Array {
  const result = new Float32Array(triples.length);
  for (let at = 0; at < triples.length; at += 3) result.set(map(triples[at], triples[at + 1], triples[at + 2]), at);
  return result;
}
