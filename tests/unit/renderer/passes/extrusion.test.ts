import { describe, expect, it } from 'vitest';
import {
  extrude,
  hullNormals,
  weld,
  writeVolume,
  type TriangleMesh,
} from '../../../../src/renderer/passes/extrusion.ts';
import { ballMesh } from '../../../../src/scenes/models/ball.ts';
import { tableMesh } from '../../../../src/scenes/models/table.ts';
import { box } from '../../../visual/solids.ts';
import { finished } from '../../../../src/base/work.ts';

type Triple = [number, number, number];

const CUBE = box([0, 0, 0], [1, 1, 1]);

/** Volume enclosed by the shadow volume of a mesh whose far end is `extent` along the light. */
function sweptVolume(mesh: TriangleMesh, travel: Triple, extent: number): number {
  const extrusion = finished(extrude(mesh));
  const { positions, normals, corners, edges } = extrusion;
  const vertices = positions.length / 3;
  const facesLight = Uint8Array.from({ length: corners.length / 3 }, (_, face) =>
    normals[3 * face] * travel[0] + normals[3 * face + 1] * travel[1] + normals[3 * face + 2] * travel[2] < 0 ? 1 : 0,
  );
  const indices = new Uint32Array(corners.length + 1.5 * edges.length);
  const end = writeVolume(extrusion, facesLight, 0, vertices, indices, 0);
  const corner = (vertex: number): Triple => {
    const carried = vertex < vertices ? 0 : extent;
    const [x, y, z] = positions.subarray(3 * (vertex % vertices), 3 * (vertex % vertices) + 3);
    return [x + carried * travel[0], y + carried * travel[1], z + carried * travel[2]];
  };
  let volume = 0;
  for (let at = 0; at < end; at += 3) {
    const [a, b, c] = [corner(indices[at]), corner(indices[at + 1]), corner(indices[at + 2])];
    volume +=
      a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return volume / 6;
}

describe('extrude', () => {
  it('sweeps a cube by its projected area times the distance', () => {
    expect(sweptVolume(CUBE, [0, -1, 0], 3)).toBeCloseTo(8 + 4 * 3, 4);
    const slant = Math.SQRT1_2;
    expect(sweptVolume(CUBE, [slant, -slant, 0], 3)).toBeCloseTo(8 + 8 * slant * 3, 4);
  });

  it('sweeps a ball by its disc, within the resolution of the mesh', () => {
    const own = sweptVolume(ballMesh(1, 24), [0, -1, 0], 0);
    expect(own).toBeGreaterThan(0.98 * ((4 / 3) * Math.PI));
    const swept = sweptVolume(ballMesh(1, 24), [0.6, -0.8, 0], 5) - own;
    expect(Math.abs(swept / (5 * Math.PI) - 1)).toBeLessThan(0.02);
  });

  it('extrudes the table, which has creased edges', () => {
    expect(sweptVolume(tableMesh(2, 0.1), [0, -1, 0], 0)).toBeCloseTo(Math.PI * 4 * 0.1, 2);
  });

  it('rejects an open mesh', () => {
    const open = { ...CUBE, indices: CUBE.indices.slice(6) };
    expect(() => finished(extrude(open))).toThrow(/not closed/);
  });

  it('rejects a mesh with an inverted face', () => {
    const flipped = { ...CUBE, indices: CUBE.indices.slice() };
    flipped.indices.set([flipped.indices[1], flipped.indices[0]], 0);
    expect(() => finished(extrude(flipped))).toThrow(RangeError);
  });
});

describe('hullNormals', () => {
  it('points out of the corners of a creased cube', () => {
    const normals = hullNormals(CUBE);
    for (let vertex = 0; vertex < CUBE.positions.length / 3; ++vertex) {
      for (let axis = 0; axis < 3; ++axis) {
        expect(normals[3 * vertex + axis]).toBeCloseTo(CUBE.positions[3 * vertex + axis] / Math.sqrt(3), 5);
      }
    }
  });
});

describe('weld', () => {
  it('gives vertices at the same place the same number', () => {
    expect(new Set(weld(CUBE.positions)).size).toBe(8);
  });
});
