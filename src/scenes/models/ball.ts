import type { TriangleMesh } from '../../passes/extrusion.ts';
import { cos, sin } from '../../sim/exact/sine.ts';

/** A closed sphere about the origin: `rings` bands from pole to pole, and twice as many segments around. */
export function ballMesh(radius: number, rings = 20): TriangleMesh {
  const segments = 2 * rings;
  const positions: number[] = [0, radius, 0];
  for (let ring = 1; ring < rings; ++ring) {
    const polar = (Math.PI * ring) / rings;
    for (let segment = 0; segment < segments; ++segment) {
      const angle = (2 * Math.PI * segment) / segments;
      const around = radius * sin(polar);
      positions.push(around * sin(angle), radius * cos(polar), around * cos(angle));
    }
  }
  positions.push(0, -radius, 0);
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(positions.map((coordinate) => coordinate / radius)),
    indices: new Uint32Array(ballIndices(rings, segments)),
  };
}

function ballIndices(rings: number, segments: number): number[] {
  const south = 1 + (rings - 1) * segments;
  const at = (ring: number, segment: number) => 1 + (ring - 1) * segments + (segment % segments);
  const indices: number[] = [];
  for (let segment = 0; segment < segments; ++segment) {
    indices.push(0, at(1, segment), at(1, segment + 1), south, at(rings - 1, segment + 1), at(rings - 1, segment));
    for (let ring = 1; ring < rings - 1; ++ring) {
      const [a, b, c, d] = [at(ring, segment), at(ring + 1, segment), at(ring + 1, segment + 1), at(ring, segment + 1)];
      indices.push(a, b, c, a, c, d);
    }
  }
  return indices;
}
