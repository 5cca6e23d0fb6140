import { describe, expect, test } from 'vitest';
import { fromHalf } from '../../../../src/renderer/puffs/billboards/layers.ts';
import { bakePuffs, samplePuff } from '../../../../src/renderer/puffs/billboards/layers.ts';
import { puffMesh } from '../../../../src/renderer/puffs/billboards/mesh.ts';
import { PUFF_PAD, rasterise } from '../../../../src/renderer/puffs/billboards/rasterise.ts';
import type { Lobe } from '../../../../src/renderer/puffs/shapes.ts';
import { FRONTS } from './fronts.ts';

const BALL: Lobe = { center: [0.1, -0.05, 0], radius: 0.8 };
const layers = bakePuffs(FRONTS);
const texel = (2 * PUFF_PAD) / layers.size;

/** Positions on a regular grid over the quad, away from the texel centres. */
const places = Array.from({ length: 90 * 90 }, (_, i): [number, number] => [
  ((i % 90) / 90 - 0.497) * 2.6,
  (Math.floor(i / 90) / 90 - 0.497) * 2.6,
]);

describe('a mesh', () => {
  const mesh = puffMesh(FRONTS[0].lobes);

  test('is closed: each edge is passed once in each direction', () => {
    const edges: string[] = [];
    for (let i = 0; i < mesh.indices.length; i += 3) {
      const [a, b, c] = mesh.indices.subarray(i, i + 3);
      edges.push(`${a},${b}`, `${b},${c}`, `${c},${a}`);
    }
    const passed = new Set(edges);
    expect(passed.size).toBe(edges.length);
    expect(edges.filter((edge) => !passed.has(edge.split(',').toReversed().join()))).toEqual([]);
  });

  test('has unit normals; without blending those of a lone lobe point away from its centre', () => {
    const single = puffMesh([BALL], 0);
    for (let i = 0; i < single.normals.length; i += 3) {
      for (let axis = 0; axis < 3; axis++) {
        const expected = (single.positions[i + axis] - BALL.center[axis]) / BALL.radius;
        expect(single.normals[i + axis]).toBeCloseTo(expected, 5);
      }
    }
    for (let i = 0; i < mesh.normals.length; i += 3) {
      expect(Math.hypot(...mesh.normals.subarray(i, i + 3))).toBeCloseTo(1, 5);
    }
  });
});

describe('a puff of one lobe', () => {
  const ball = bakePuffs([{ name: 'ball', lobes: [BALL] }]);
  const inside = places.filter(([x, y]) => Math.hypot(x - BALL.center[0], y - BALL.center[1]) < 0.75);

  test('has the height and the normals of a sphere', () => {
    for (const [x, y] of inside) {
      const [dx, dy] = [x - BALL.center[0], y - BALL.center[1]];
      const z = Math.sqrt(BALL.radius ** 2 - dx * dx - dy * dy);
      const { normal, height } = samplePuff(ball, 0, x, y);
      // Error along the normal, because the surface is steep near the rim. It includes the facets of the mesh and the
      // filter.
      expect((Math.abs(height - z) * z) / BALL.radius).toBeLessThan(0.005 * BALL.radius);
      const cosine = (normal[0] * dx + normal[1] * dy + normal[2] * z) / BALL.radius;
      expect(cosine).toBeGreaterThan(0.9995);
    }
  });

  test('has a continuous height: no step between close places beyond the slope', () => {
    for (const [x, y] of inside) {
      const step = 0.002;
      const slope = 0.75 / Math.sqrt(BALL.radius ** 2 - 0.75 ** 2);
      const rise = samplePuff(ball, 0, x + step, y).height - samplePuff(ball, 0, x, y).height;
      expect(Math.abs(rise)).toBeLessThan(step * slope * 1.5);
    }
  });

  test('has the signed distance of a disc within half a texel, as far as it is stored', () => {
    for (const [x, y] of places) {
      const expected = Math.hypot(x - BALL.center[0], y - BALL.center[1]) - BALL.radius;
      const clamped = Math.min(ball.distanceRange / 2, Math.max(-ball.distanceRange / 2, expected));
      expect(Math.abs(samplePuff(ball, 0, x, y).distance - clamped)).toBeLessThan(texel / 2);
    }
  });

  test('has the figures of a ball', () => {
    const { silhouetteRadius, inscribedRadius, outerRadius, relief } = ball.figures[0];
    const offset = Math.hypot(BALL.center[0], BALL.center[1]);
    expect(Math.abs(silhouetteRadius - BALL.radius)).toBeLessThan(texel / 4);
    expect(Math.abs(inscribedRadius - (BALL.radius - offset))).toBeLessThan(texel / 2);
    expect(Math.abs(outerRadius - (BALL.radius + offset))).toBeLessThan(texel / 2);
    expect(Math.abs(relief - BALL.radius)).toBeLessThan(0.005);
  });
});

describe('the layers of all shapes', () => {
  test('hold unit normals that face the viewer where the puff is', () => {
    FRONTS.forEach(({ lobes }) => {
      const { normals, depths } = rasterise(puffMesh(lobes), layers.size);
      depths.forEach((depth, i) => {
        if (depth === -Infinity) return;
        const [x, y, z] = normals.subarray(3 * i, 3 * i + 3);
        expect(Math.hypot(x, y, z)).toBeCloseTo(1, 5);
        expect(z).toBeGreaterThan(-0.2);
      });
    });
  });

  test('repeat the border outside the silhouette, so that filtering reads no background', () => {
    for (let layer = 0; layer < layers.count; layer++) {
      for (const [x, y] of places) {
        const outside = samplePuff(layers, layer, x, y);
        if (outside.distance <= 0 || outside.distance > 0.3) continue;
        // Along the gradient of the distance to the border, where the puff's own values apply.
        const gradient = [0, 1].map((axis) => {
          const step = axis === 0 ? [texel, 0] : [0, texel];
          const ahead = samplePuff(layers, layer, x + step[0], y + step[1]).distance;
          return ahead - samplePuff(layers, layer, x - step[0], y - step[1]).distance;
        });
        const length = Math.hypot(...gradient);
        if (length < 1.8 * texel) continue; // A ridge between two lobes is equally far from two borders.
        const back = outside.distance + texel;
        const border = samplePuff(layers, layer, x - (gradient[0] / length) * back, y - (gradient[1] / length) * back);
        const agreement = outside.normal.reduce((sum, n, axis) => sum + n * border.normal[axis], 0);
        expect(agreement).toBeGreaterThan(0.75);
        expect(Math.abs(outside.height - border.height)).toBeLessThan(0.3);
      }
    }
  });

  test('hold only finite numbers of Eq. 1 between 0 and 1', () => {
    const values = Array.from(layers.normalDepth, fromHalf);
    expect(values.filter((value) => !(value >= 0 && value <= 1))).toEqual([]);
  });

  test('with 8 bits hold the integers of Eq. 1, within half a step of N and d as half floats', () => {
    const printed = bakePuffs(FRONTS, { precision: 8 });
    expect(printed.normalDepth).toBeInstanceOf(Uint8Array);
    const worst = { N: 0, d: 0 };
    printed.normalDepth.forEach((byte, at) => {
      const share = fromHalf(layers.normalDepth[at]);
      if (at % 4 === 3) worst.d = Math.max(worst.d, Math.abs(byte / 255 - 0.5 - (share - 0.5)));
      else worst.N = Math.max(worst.N, Math.abs((2 * byte) / 255 - 1 - (2 * share - 1)));
    });
    // A half float between 1/2 and 1 is itself rounded by up to 2^-12.
    for (const [step, error, rounding] of [
      [2 / 255, worst.N, 2 ** -11],
      [1 / 255, worst.d, 2 ** -12],
    ]) {
      expect(error).toBeLessThanOrEqual(step / 2 + rounding);
      expect(error).toBeGreaterThan(0.45 * step);
    }
    for (const [x, y] of places.filter((_, at) => at % 7 === 0)) {
      const [rough, fine] = [printed, layers].map((each) => samplePuff(each, 0, x, y));
      expect(Math.abs(rough.height - fine.height)).toBeLessThanOrEqual((1 / 510 + 2 ** -12) * 2 * PUFF_PAD);
      expect(rough.normal.reduce((sum, n, axis) => sum + n * fine.normal[axis], 0)).toBeGreaterThan(0.9999);
      expect(rough.distance).toBe(fine.distance);
    }
  });

  test('are reproducible, with a quarter of the texels at half the size', () => {
    const again = bakePuffs(FRONTS);
    expect(again.normalDepth).toEqual(layers.normalDepth);
    expect(again.colorCoverage).toEqual(layers.colorCoverage);
    const small = bakePuffs(FRONTS, { size: 64 });
    expect(small.normalDepth.length).toBe(layers.normalDepth.length / 4);
    expect(small.figures[0].silhouetteRadius).toBeCloseTo(layers.figures[0].silhouetteRadius, 2);
  });

  test('are rasterized from front faces: few coordinates are read for each cell', () => {
    const mesh = puffMesh(FRONTS[0].lobes);
    let reads = 0;
    const positions = new Proxy(mesh.positions, {
      get: (target, key) => (reads++, Reflect.get(target, key) as unknown),
    });
    const { coverage } = rasterise({ ...mesh, positions }, layers.size);
    // With back faces there would be 1.5 times as many.
    expect(reads).toBeLessThan(4.5 * coverage.length);
  });
});
