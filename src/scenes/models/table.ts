import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import { cos, sin } from '../../simulator/exact/sine.ts';
import { every, strideWithin } from './revolve.ts';

const SEGMENTS = 96;

/** A closed round table top. Its upper face is at y = 0; the rim below it has sharp edges. */
export function tableMesh(radius: number, thickness: number): TriangleMesh {
  const positions: number[] = [];
  const normals: number[] = [];
  const ring = (y: number, normal: (x: number, z: number) => number[]) => {
    const first = positions.length / 3;
    for (let segment = 0; segment < SEGMENTS; ++segment) {
      const angle = (2 * Math.PI * segment) / SEGMENTS;
      const [x, z] = [sin(angle), cos(angle)];
      positions.push(radius * x, y, radius * z);
      normals.push(...normal(x, z));
    }
    return first;
  };
  const top = ring(0, () => [0, 1, 0]);
  const upper = ring(0, (x, z) => [x, 0, z]);
  const lower = ring(-thickness, (x, z) => [x, 0, z]);
  const bottom = ring(-thickness, () => [0, -1, 0]);
  const triangles = (stride: number): Uint32Array => {
    const indices: number[] = [];
    const columns = every(stride, SEGMENTS);
    columns.slice(1).forEach((end, index) => {
      const [segment, next] = [columns[index], end % SEGMENTS];
      indices.push(upper + segment, lower + segment, lower + next, upper + segment, lower + next, upper + next);
      if (segment > 0 && next > 0)
        indices.push(top, top + segment, top + next, bottom, bottom + next, bottom + segment);
    });
    return new Uint32Array(indices);
  };
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    indices: triangles(1),
    coarser: (deviation) => triangles(strideWithin(deviation, radius, SEGMENTS)),
  };
}
