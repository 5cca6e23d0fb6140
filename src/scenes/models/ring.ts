import type { TriangleMesh } from '../../passes/extrusion.ts';
import { cos, sin } from '../../sim/exact/sine.ts';

/**
 * A flat ring about the vertical with a square section, closed, with sharp edges.
 * @param inner, outer radii; metres, as are the heights of its lower and its upper face
 */
export function ringMesh(inner: number, outer: number, bottom: number, top: number, segments = 96): TriangleMesh {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  const band = (from: readonly [number, number], to: readonly [number, number], out: number, up: number) => {
    const first = positions.length / 3;
    for (let segment = 0; segment < segments; segment++) {
      const angle = (2 * Math.PI * segment) / segments;
      const [x, z] = [cos(angle), sin(angle)];
      for (const [radius, height] of [from, to]) positions.push(radius * x, height, radius * z);
      for (let end = 0; end < 2; end++) normals.push(out * x, up, out * z);
      const [here, next] = [first + 2 * segment, first + 2 * ((segment + 1) % segments)];
      indices.push(here, here + 1, next + 1, here, next + 1, next);
    }
  };
  band([outer, bottom], [outer, top], 1, 0);
  band([outer, top], [inner, top], 0, 1);
  band([inner, top], [inner, bottom], -1, 0);
  band([inner, bottom], [outer, bottom], 0, -1);
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    indices: Uint32Array.from(indices),
  };
}
