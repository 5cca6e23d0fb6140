/** Billboards of closed meshes: N, d, C and coverage of the mesh itself, not of the lobes that approximate it. */
import { beforeAll, describe, expect, test } from 'vitest';
import { BoxGeometry, SphereGeometry, type BufferGeometry } from 'three';
import { bakePuffs, samplePuff, type PuffLayers } from '../../../../src/renderer/puffs/billboards/layers.ts';
import { PUFF_PAD } from '../../../../src/renderer/puffs/billboards/rasterise.ts';
import type { PlainMesh } from '../../../../src/renderer/puffs/fit/closedMesh.ts';
import { fitPuff } from '../../../../src/renderer/puffs/fit/fitPuff.ts';
import { billboardShapes } from '../../../../src/renderer/puffs/billboards/sides.ts';
import { keyOf, type PixelImage, type PuffShape } from '../../../../src/renderer/puffs/shapes.ts';
import { finished } from '../../../../src/base/work.ts';
import { bakingBillboards } from '../../../../src/renderer/billboards.ts';
import { LOBE_SHAPES } from '../../../../src/renderer/puffs/lobeShapes.ts';
import { face, halves, torus, TORUS } from '../../../visual/puffMeshes.ts';

const TEXEL = (2 * PUFF_PAD) / 128;
/** Positions on a regular grid over the quad, away from the texel centres. */
const PLACES = Array.from({ length: 90 * 90 }, (_, i): [number, number] => [
  ((i % 90) / 90 - 0.497) * 2.6,
  (Math.floor(i / 90) / 90 - 0.497) * 2.6,
]);

interface Baked {
  readonly layers: PuffLayers;
  /** Centre and half the width of the mesh in the unit space of the puff. */
  readonly middle: readonly number[];
  readonly half: number;
}

async function fitted(mesh: PlainMesh): Promise<PuffShape> {
  return (await fitPuff(mesh, { lobes: 5 })).shape;
}

async function baked(mesh: PlainMesh): Promise<Baked> {
  const shapes = billboardShapes([await fitted(mesh)]);
  const { positions } = shapes[0].mesh!;
  const ends = [0, 1, 2].map((axis) => {
    const all = positions.filter((_, at) => at % 3 === axis);
    return [all.reduce((a, b) => Math.min(a, b)), all.reduce((a, b) => Math.max(a, b))];
  });
  return {
    layers: bakePuffs(shapes),
    middle: ends.map(([low, high]) => (low + high) / 2),
    half: (ends[0][1] - ends[0][0]) / 2,
  };
}

/** C at a position, 0..255, from the texel there. */
function colorAt({ size, colorCoverage }: PuffLayers, x: number, y: number): number[] {
  const [column, row] = [x, y].map((at) => Math.floor((at / PUFF_PAD + 1) * 0.5 * size));
  return [...colorCoverage.subarray(4 * (row * size + column), 4 * (row * size + column) + 3)];
}

describe('a ball', () => {
  let ball: Baked;
  let lobe: PuffLayers;
  beforeAll(async () => {
    const { positions, normals, indices } = halves([1, 1, 1], [1, 1, 1]);
    ball = await baked({ positions, normals, indices });
    lobe = bakePuffs([{ name: 'ball', lobes: [{ center: [0, 0, 0], radius: ball.half }] }]);
  });

  test('has the normals, heights and outline of a puff of one lobe', () => {
    for (const [x, y] of PLACES) {
      const [mesh, exact] = [ball.layers, lobe].map((layers) => samplePuff(layers, 0, x, y));
      expect(Math.abs(mesh.distance - exact.distance)).toBeLessThan(0.6 * TEXEL);
      if (exact.distance > -2 * TEXEL) continue;
      // Along the normal, because the surface is steep near the rim.
      expect(Math.abs(mesh.height - exact.height) * exact.normal[2]).toBeLessThan(0.006);
      expect(mesh.normal.reduce((sum, n, axis) => sum + n * exact.normal[axis], 0)).toBeGreaterThan(0.999);
    }
  });

  test('without colours is white to the bit, as lobes are', () => {
    const notWhite = (layers: PuffLayers) => layers.colorCoverage.filter((byte, at) => at % 4 < 3 && byte !== 255);
    expect(notWhite(ball.layers)).toHaveLength(0);
    expect(notWhite(lobe)).toHaveLength(0);
  });

  test('has the same normals if the mesh has none, or is inside out', async () => {
    const { positions, indices, normals } = arraysOf(new SphereGeometry(1, 64, 33));
    const inverted = { positions, indices: indices.toReversed(), normals: normals.map((at) => -at) };
    for (const mesh of [{ positions, indices }, { positions, indices: indices.toReversed() }, inverted]) {
      const { layers } = await baked(mesh);
      for (const [x, y] of PLACES) {
        const [other, exact] = [layers, lobe].map((each) => samplePuff(each, 0, x, y));
        if (exact.distance > -2 * TEXEL) continue;
        expect(other.normal.reduce((sum, n, axis) => sum + n * exact.normal[axis], 0)).toBeGreaterThan(0.995);
      }
    }
  });
});

test('a torus has a hole: its silhouette, heights and normals are exact', async () => {
  const { layers, middle, half } = await baked(torus());
  const [ring, tube] = TORUS.map((radius) => (radius * half) / (TORUS[0] + TORUS[1]));
  let inHole = 0;
  for (const [x, y] of PLACES) {
    const [right, up] = [x - middle[0], y - middle[1]];
    const out = Math.hypot(right, up) - ring;
    const { distance, height, normal } = samplePuff(layers, 0, x, y);
    const clamped = Math.min(layers.distanceRange / 2, Math.abs(out) - tube);
    expect(Math.abs(distance - clamped)).toBeLessThan(0.55 * TEXEL);
    if (distance > 0 && out < 0) inHole++;
    if (distance > -2 * TEXEL) continue;
    const above = Math.sqrt(tube * tube - out * out);
    expect((Math.abs(height - middle[2] - above) * above) / tube).toBeLessThan(0.006);
    const exact = [(right / (out + ring)) * (out / tube), (up / (out + ring)) * (out / tube), above / tube];
    expect(normal.reduce((sum, n, axis) => sum + n * exact[axis], 0)).toBeGreaterThan(0.998);
  }
  expect(inHole).toBeGreaterThan(200);
});

test('a box without normals keeps its edges sharp', async () => {
  const { positions, indices } = arraysOf(new BoxGeometry(1, 1, 1).rotateX(0.5).rotateY(0.6));
  const { layers } = await baked({ positions, indices });
  const inside = PLACES.map(([x, y]) => samplePuff(layers, 0, x, y)).filter(({ distance }) => distance < -2 * TEXEL);
  const counts = new Map<string, number>();
  for (const { normal } of inside) {
    const key = normal.map((at) => at.toFixed(2)).join();
    counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  const [first, second, third] = [...counts.values()].sort((a, b) => b - a);
  expect(third).toBeGreaterThan(100);
  // The rest are texels on an edge.
  expect(first + second + third).toBeGreaterThan(0.9 * inside.length);
});

describe('colours', () => {
  test('are those of the vertices, which continue outside the silhouette', async () => {
    const { layers } = await baked(halves([1, 0.8, 0.2], [0.2, 0.4, 1]));
    for (const [x, y] of PLACES) {
      if (Math.abs(y) < 0.12 || Math.abs(x) > 1.25 || Math.abs(y) > 1.25) continue;
      expect(colorAt(layers, x, y)).toEqual(y > 0 ? [255, 204, 51] : [51, 102, 255]);
    }
  });

  test('are those of the texture, its first row at the top, times those of the vertices', async () => {
    const [width, height] = [64, 32];
    const data = new Uint8Array(4 * width * height);
    for (let at = 0; at < width * height; at++)
      data.set([4 * (at % width), 8 * Math.floor(at / width), 255, 9], 4 * at);
    // As an ImageData, whose fields are those of its prototype.
    const texture = Object.create({ width, height, data }) as PixelImage;
    const mesh = { ...face(), texture };
    const colors = Array.from({ length: mesh.positions.length }, (_, at) => (at % 3 === 2 ? 0.5 : 1));
    const { layers } = await baked({ ...mesh, colors });
    // The front of the ball has u = 1/4 and v = 1/2 in its middle.
    const [middle, right, up] = [colorAt(layers, 0, 0), colorAt(layers, 0.5, 0), colorAt(layers, 0, 0.5)];
    expect(Math.abs(middle[0] - 63)).toBeLessThan(5);
    expect(Math.abs(middle[1] - 128)).toBeLessThan(6);
    expect(middle[2]).toBe(128);
    // 30 degrees are a twelfth of the width and a sixth of the height.
    expect(right[0] - middle[0]).toBeCloseTo(256 / 12, -1);
    expect(up[1] - middle[1]).toBeCloseTo(-256 / 6, -1);
  });
});

describe('sides', () => {
  test('show a mesh from eight directions around its y axis, the first from the front', async () => {
    const shape = await fitted(compass());
    const shapes = billboardShapes([shape], 8);
    expect(shapes).toHaveLength(8);
    expect(shapes[0]).toEqual(billboardShapes([shape])[0]);
    const layers = bakePuffs(shapes);
    for (let side = 0; side < 8; side++) {
      // The colour in the middle says which part of the ball is there: red to the right, blue to the front.
      const middle = (side * layers.size + layers.size / 2) * layers.size + layers.size / 2;
      const [right, , front] = layers.colorCoverage.subarray(4 * middle, 4 * middle + 3);
      const angle = (side / 8) * 2 * Math.PI;
      expect(Math.abs(right - 127.5 * (1 - Math.sin(angle)))).toBeLessThan(5);
      expect(Math.abs(front - 127.5 * (1 + Math.cos(angle)))).toBeLessThan(5);
    }
  });

  test('of lobes are those of the turned puff, raised to the centre plane', () => {
    const [front, , right] = billboardShapes(LOBE_SHAPES.slice(0, 1), 8);
    LOBE_SHAPES[0].lobes.forEach(({ center: [x, y, z], radius }, at) => {
      expect(front.lobes[at]).toEqual({ center: [x, y, Math.max(z, 0)], radius });
      expect(right.lobes[at]).toEqual({ center: [z, y, Math.max(-x, 0)].map((c) => expect.closeTo(c)), radius });
    });
  });

  test('have a layer, start caps, casters and solids each', async () => {
    const { layers, sides, startCaps, casters, solids, casterSolids } = finished(
      bakingBillboards([await fitted(compass()), LOBE_SHAPES[0]], 16, 4),
    );
    expect([sides, layers.count, startCaps.count, casters.count]).toEqual([4, 8, 8, 8]);
    for (const { table, balls } of [solids, casterSolids!]) expect(table).toHaveLength(8 * 4 * balls);
  });
});

test('shapes with the same lobes and other meshes are not the same shapes', async () => {
  const plain = await fitted(halves([1, 1, 1], [1, 1, 1]));
  const { name, lobes } = plain;
  expect(keyOf([plain])).toBe(keyOf([{ ...plain }]));
  expect(keyOf([plain])).not.toBe(keyOf([{ name, lobes }]));
  expect(keyOf([plain])).not.toBe(keyOf([{ name, lobes, mesh: { ...plain.mesh! } }]));
});

/** A ball whose colours say where a point is: red to the right, green up, blue to the front. */
function compass(): PlainMesh {
  const ball = arraysOf(new SphereGeometry(1, 64, 33));
  return { ...ball, colors: ball.normals.map((at) => (at + 1) / 2) };
}

function arraysOf({ attributes, index }: BufferGeometry) {
  return {
    positions: Float32Array.from(attributes.position.array),
    normals: Float32Array.from(attributes.normal.array),
    indices: Uint32Array.from(index!.array),
  };
}
