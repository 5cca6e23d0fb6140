/** Wings of the dragon: a membrane between fingers that fan out from an elbow. */
import type { TriangleMesh } from '../../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../../renderer/passes/surface.ts';
import type { Vector } from '../../scene.ts';
import { FINS, SCALES } from './dragon.ts';
import { tube } from '../lathe.ts';
import { merged } from '../place.ts';

const ELBOW = [0.3, 0.5] as const;
/** Tips of the fingers, from the upper one down. */
const TIPS = [[1.2, 0.86], [1.22, 0.22], [0.86, -0.2]] as const; // prettier-ignore
/** Half the thickness of the membrane, metres. */
const HALF = 0.022;

/**
 * About the shoulder, in the plane of its own x and y.
 * @param side 1 is the left wing
 * @param part index of the part that carries it
 */
export function wing(side: 1 | -1, part: number): SurfaceDescription[] {
  const name = side > 0 ? 'left' : 'right';
  const look = { casts: true, inked: true, part };
  return [
    { name: `${name} membrane`, mesh: slab(membrane()), color: FINS, ...look },
    { name: `${name} fingers`, mesh: fingers(), color: SCALES, ...look },
  ];
}

/** The outline, anticlockwise, with an arc between neighbouring fingers. */
function membrane(): readonly (readonly [number, number])[] {
  const ends = [[0.05, -0.1], ...TIPS.toReversed()] as const;
  const scallops = ends.slice(1).flatMap((to, index) => {
    const from = ends[index];
    return Array.from({ length: 8 }, (_, at) => {
      const share = at / 8;
      const bend = 0.5 * share * (1 - share);
      return [0, 1].map((axis) => {
        const straight = from[axis] + share * (to[axis] - from[axis]);
        return straight + bend * (ELBOW[axis] - straight);
      }) as unknown as readonly [number, number];
    });
  });
  return [...scallops, TIPS[0], ELBOW, [0, 0.08]];
}

function fingers(): TriangleMesh {
  const bone = (points: readonly (readonly [number, number])[], radius: number) =>
    tube(
      10,
      points.map(([x, y]): Vector => [x, y, 0]),
      [0, 0, 1],
      [[0, 0], [radius, 0.02]],
      [[radius, 0.02], [0.35 * radius, 0.98]],
      [[0.35 * radius, 0.98], [0, 1]],
    ); // prettier-ignore
  return merged(bone([[-0.08, -0.06], [0.1, 0.28], ELBOW, [0.74, 0.74], TIPS[0]], 0.09), bone([ELBOW, TIPS[1]], 0.05), bone([ELBOW, TIPS[2]], 0.05)); // prettier-ignore
}

/** A closed plate with this outline, all of which its elbow sees. */
function slab(outline: readonly (readonly [number, number])[]): TriangleMesh {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  const vertex = (x: number, y: number, z: number, normal: readonly number[]): number => {
    positions.push(x, y, z);
    normals.push(...normal);
    return positions.length / 3 - 1;
  };
  // Slightly inside the outline, where it bends at the elbow.
  const [middleX, middleY] = [ELBOW[0] + 0.12, ELBOW[1] - 0.1];
  for (const face of [1, -1]) {
    const normal = [0, 0, face];
    const middle = vertex(middleX, middleY, face * HALF, normal);
    const rim = outline.map(([x, y]) => vertex(x, y, face * HALF, normal));
    rim.forEach((corner, at) => {
      const next = rim[(at + 1) % rim.length];
      indices.push(middle, ...(face > 0 ? [corner, next] : [next, corner]));
    });
  }
  outline.forEach(([x, y], at) => {
    const [toX, toY] = outline[(at + 1) % outline.length];
    const length = Math.sqrt((toX - x) * (toX - x) + (toY - y) * (toY - y));
    const normal = [(toY - y) / length, (x - toX) / length, 0];
    const [a, b, c, d] = [
      vertex(x, y, HALF, normal),
      vertex(x, y, -HALF, normal),
      vertex(toX, toY, -HALF, normal),
      vertex(toX, toY, HALF, normal),
    ];
    indices.push(a, b, c, a, c, d);
  });
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    indices: Uint32Array.from(indices),
  };
}
