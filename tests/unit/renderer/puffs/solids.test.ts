import { describe, expect, it } from 'vitest';
import { bakePuffs, samplePuff } from '../../../../src/renderer/puffs/billboards/layers.ts';
import { LOBE_SHAPES } from '../../../../src/renderer/puffs/lobeShapes.ts';
import { billboardShapes } from '../../../../src/renderer/puffs/billboards/sides.ts';
import { solidsOf, type PuffSolids } from '../../../../src/renderer/puffs/bake/solids.ts';
import { finished } from '../../../../src/base/work.ts';
import { bakingBillboards } from '../../../../src/renderer/billboards.ts';
import { fitPuff } from '../../../../src/renderer/puffs/fit/fitPuff.ts';
import { heart, popcorn, rings, torus } from '../../../visual/puffMeshes.ts';

/** Height of a variation's balls, each enlarged by `growth`, at a position; -Infinity outside all balls. */
function heightOf({ table, balls }: PuffSolids, variation: number, [x, y]: [number, number], growth: number): number {
  const at = (column: number, ball: number) => table[(4 * variation + column) * balls + ball];
  const heights = Array.from({ length: balls }, (_, ball) => {
    const radius = at(3, ball) === 0 ? 0 : at(3, ball) + growth;
    const squared = radius * radius - (x - at(0, ball)) ** 2 - (y - at(1, ball)) ** 2;
    return squared > 0 && radius > 0 ? at(2, ball) + Math.sqrt(squared) : -Infinity;
  });
  return Math.max(...heights);
}

describe('the solids of puffs', () => {
  it('are the lobes, column by column, padded with absent ones', () => {
    const { table, balls } = solidsOf(
      LOBE_SHAPES.map(({ lobes }) => lobes),
      { facesEye: 0, tolerance: 0, blur: 0 },
    );
    expect(balls).toBe(12);
    expect(table).toHaveLength(LOBE_SHAPES.length * 48);
    LOBE_SHAPES.forEach(({ lobes }, variation) => {
      for (let ball = 0; ball < balls; ball++) {
        const numbers = [0, 1, 2, 3].map((column) => table[(4 * variation + column) * balls + ball]);
        const expected = ball < lobes.length ? [...lobes[ball].center, lobes[ball].radius] : [0, 0, 0, 0];
        expect(numbers).toEqual(expected.map(Math.fround));
      }
    });
  });

  it('reject more lobes than the limit', () => {
    const lobes = Array.from({ length: 13 }, () => ({ center: [0, 0, 0] as const, radius: 1 }));
    const drawn = { facesEye: 0, tolerance: 0, blur: 0 } as const;
    expect(() => solidsOf([lobes], drawn)).toThrow(/13 lobes/);
  });

  it.each([
    ['the default puffs', () => LOBE_SHAPES],
    [
      'meshes',
      () =>
        Promise.all(
          [torus(), heart(), rings(), popcorn()].map(async (mesh) => (await fitPuff(mesh, { lobes: 6 })).shape),
        ),
    ],
  ] as const)('bound the baked layers of %s from inside and outside within the tolerance', async (_, shapesOf) => {
    const shapes = await shapesOf();
    const layers = bakePuffs(billboardShapes(shapes));
    const { solids } = finished(bakingBillboards(shapes));
    let inside = 0;
    for (let place = 0; place < 4 * 2500; place++) {
      const variation = place % 4;
      const point: [number, number] = [((place >> 2) % 50) / 24.5 - 1, Math.floor(place / 200) / 24.5 - 1];
      const { height, distance } = samplePuff(layers, variation, ...point);
      const least = heightOf(solids, variation, point, -solids.tolerance);
      if (least > -Infinity) {
        expect(distance).toBeLessThan(0);
        expect(height).toBeGreaterThan(least - solids.tolerance);
        inside++;
      }
      if (distance < 0)
        expect(height).toBeLessThan(heightOf(solids, variation, point, solids.tolerance) + solids.tolerance);
    }
    expect(inside).toBeGreaterThan(shapes === LOBE_SHAPES ? 3000 : 500);
  });
});
