import type { TriangleMesh } from '../../passes/extrusion.ts';
import { cos, sin } from '../../sim/exact/sine.ts';

const SEGMENTS = 96;

/** A closed round table top. Its upper face is at y = 0; the rim below it has sharp edges. */
export function tableMesh(radius: number, thickness: number): TriangleMesh {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
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
  for (let segment = 0; segment < SEGMENTS; ++segment) {
    const next = (segment + 1) % SEGMENTS;
    indices.push(upper + segment, lower + segment, lower + next, upper + segment, lower + next, upper + next);
  }
  for (let segment = 1; segment < SEGMENTS - 1; ++segment) {
    indices.push(top, top + segment, top + segment + 1, bottom, bottom + segment + 1, bottom + segment);
  }
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    indices: new Uint32Array(indices),
  };
}
