import { Euler, Matrix3, Matrix4, Quaternion, Vector3 } from 'three';
import { inOne, type TriangleMesh } from '../../passes/extrusion.ts';
import type { Placement, Turn, Vector } from '../scene.ts';

/** How a mesh is put somewhere: scaled, then turned, then moved. */
export interface Stand {
  readonly at?: Vector;
  /** Radians about x, then y, then z, each about the world's axis. */
  readonly turn?: Vector;
  /** Along each of its own axes; above 0. */
  readonly scale?: Vector | number;
}

/** The mesh where it stands, with unit normals. */
export function placed({ positions, normals, indices }: TriangleMesh, { at, turn, scale }: Stand): TriangleMesh {
  const size = typeof scale === 'number' ? ([scale, scale, scale] as const) : (scale ?? ([1, 1, 1] as const));
  const matrix = new Matrix4().compose(
    new Vector3(...(at ?? [0, 0, 0])),
    new Quaternion(...turnBy(turn ?? [0, 0, 0])),
    new Vector3(...size),
  );
  const normalMatrix = new Matrix3().getNormalMatrix(matrix);
  return {
    positions: mapped(positions, (point) => point.applyMatrix4(matrix)),
    normals: mapped(normals, (normal) => normal.applyMatrix3(normalMatrix).normalize()),
    indices,
  };
}

/** Several meshes as one. */
export function merged(...meshes: readonly TriangleMesh[]): TriangleMesh {
  const first = meshes.map((_, index) => meshes.slice(0, index).reduce((sum, m) => sum + m.positions.length / 3, 0));
  return {
    positions: inOne(meshes.map(({ positions }) => positions)),
    normals: inOne(meshes.map(({ normals }) => normals)),
    indices: Uint32Array.from(meshes.flatMap(({ indices }, index) => Array.from(indices, (i) => i + first[index]))),
  };
}

/** Angles about x, then y, then z, each about the world's axis (radians), as a quaternion. */
export function turnBy([x, y, z]: Vector): Turn {
  const [i, j, k, w] = new Quaternion().setFromEuler(new Euler(x, y, z, 'ZYX'));
  return [i, j, k, w];
}

/** Where nothing is moved and nothing turned but what is given. */
export function placement(position: Vector = [0, 0, 0], turn: Vector = [0, 0, 0]): Placement {
  return { position, rotation: turnBy(turn) };
}

function mapped(triples: Float32Array, map: (vector: Vector3) => Vector3): Float32Array {
  const result = new Float32Array(triples.length);
  const vector = new Vector3();
  for (let from = 0; from < triples.length; from += 3) map(vector.fromArray(triples, from)).toArray(result, from);
  return result;
}
