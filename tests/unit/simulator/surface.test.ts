import { describe, expect, it } from 'vitest';
import { ParameterError } from '../../../src/base/errors.ts';
import { EVERYTHING } from '../../support/sim/everything.ts';
import { JET, loadVariant } from '../../support/sim/simWasm.ts';

/** Two triangles at z = 5. */
const VERTICES = [0, 0, 5, 1, 0, 5, 0, 1, 5, 1, 1, 5];
const INDICES = [0, 1, 2, 2, 1, 3];

describe('a surface of a mesh', () => {
  it('emits smoke and is part of the saved state', async () => {
    const factory = await loadVariant('core');
    const simulator = factory.create({ capacity: 256, seed: 1 });
    expect(simulator.addSurface(new Float32Array(VERTICES), new Uint32Array(INDICES))).toBe(0);
    expect(simulator.addSurface(VERTICES, INDICES.slice(0, 3))).toBe(1);
    simulator.set({ ...JET, 'emitters.0.shape': 8, 'emitters.0.speed': 0, 'buoyancy.acceleration': 0 });
    simulator.step(20);
    const { count, place } = simulator.arrange(EVERYTHING).rows;
    expect(count).toBeGreaterThan(100);
    for (let row = 0; row < count; row++) {
      expect(place[4 * row + 2]).toBeCloseTo(5, 5);
      expect(Math.abs(place[4 * row] - 0.5)).toBeLessThanOrEqual(0.5001);
    }
    const other = factory.create({ capacity: 256, seed: 2 });
    other.restore(simulator.save());
    simulator.step(50);
    other.step(50);
    expect(other.hash()).toBe(simulator.hash());
    simulator.dispose();
    other.dispose();
  });

  it('is rejected with the name of the invalid value', async () => {
    const simulator = (await loadVariant('core')).create({ capacity: 16, seed: 1 });
    const cases: [number[], number[], string][] = [
      [[], INDICES, 'surface.vertices'],
      [VERTICES.slice(1), INDICES, 'surface.vertices'],
      [[...VERTICES.slice(0, 11), NaN], INDICES, 'surface.vertices.11'],
      [VERTICES, [0, 1, 4], 'surface.indices.2'],
      [VERTICES, [0, -1, 2], 'surface.indices.1'],
      [VERTICES, [0, 1], 'surface.indices'],
      [VERTICES, [0, 1, 1], 'surface.area'],
    ];
    for (const [vertices, indices, key] of cases) {
      let rejected: unknown;
      try {
        simulator.addSurface(vertices, indices);
      } catch (error) {
        rejected = error;
      }
      expect(rejected, key).toBeInstanceOf(ParameterError);
      expect((rejected as ParameterError).key).toBe(key);
    }
    simulator.dispose();
  });
});
