import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import { cos, sin } from '../../simulator/exact/sine.ts';
import { every, strideWithin } from './revolve.ts';

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
    indices: ballIndices(rings, 1),
    coarser: (deviation) => ballIndices(rings, strideWithin(deviation, radius, segments)),
  };
}

/** The triangles between every n-th ring and segment. */
function ballIndices(rings: number, stride: number): Uint32Array {
  const segments = 2 * rings;
  const south = 1 + (rings - 1) * segments;
  const at = (ring: number, segment: number) => 1 + (ring - 1) * segments + (segment % segments);
  const indices: number[] = [];
  const kept = every(stride, rings).slice(1, -1);
  const [first, last] = [kept[0], kept.at(-1)!];
  const columns = every(stride, segments);
  columns.slice(1).forEach((next, index) => {
    const segment = columns[index];
    indices.push(0, at(first, segment), at(first, next), south, at(last, next), at(last, segment));
    kept.slice(1).forEach((below, band) => {
      const [a, b, c, d] = [at(kept[band], segment), at(below, segment), at(below, next), at(kept[band], next)];
      indices.push(a, b, c, a, c, d);
    });
  });
  return Uint32Array.from(indices);
}
