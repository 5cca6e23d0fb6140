import { describe, expect, it } from 'vitest';
import {
  TEMPERATURE_MAX,
  ATTRIBUTE_WORDS,
  PLACE_FLOATS,
  readAttributes,
  RIGID_FLOATS,
  ROW_BYTES,
} from '../../../src/sim/rows.ts';
import { VIEW_FLOATS, VIEW_OFFSETS, viewLength, writeView, type View } from '../../../src/sim/view.ts';
import * as core from '../../../src/sim/wasm/core/bindings.js';
import * as physics from '../../../src/sim/wasm/physics/bindings.js';
import { EVERYTHING } from '../../support/sim/everything.ts';
import { JET, loadVariant } from '../../support/sim/simWasm.ts';

describe('the layout of rows and views', () => {
  it('is the one reported by the WASM', async () => {
    for (const [variant, { layout }] of Object.entries({ core, physics })) {
      await loadVariant(variant as 'core' | 'physics');
      expect([...layout()], variant).toEqual([PLACE_FLOATS, ATTRIBUTE_WORDS, VIEW_FLOATS, RIGID_FLOATS]);
    }
    expect(ROW_BYTES).toBe(24);
  });

  it('writes each part of a view at its own offset', () => {
    const view: View = {
      purpose: 'light',
      blend: 0.25,
      cull: true,
      pad: 0.5,
      clipFromWorld: Array.from({ length: 16 }, (_, index) => 100 + index),
      direction: [0, -0.6, 0.8],
      reach: 1.5,
      receivers: { min: [-1, -2, -3], max: [1, 2, 3] },
      coverage: {
        covers: 2,
        pixel: 0.125,
        nearest: -4,
        farthest: 50,
        lift: 0.75,
        lifters: [[6, 5, 4, 3, 2, 1]],
        capRange: [-0.5, 0.5],
        startCaps: { values: new Float32Array([0.25, 0.375]) },
        depth: 1.25,
        solids: { table: new Float32Array([9, 8, 7]), balls: 4, facesEye: true, tolerance: 0.0625, blur: 3 },
      },
    };
    const floats = new Float32Array(viewLength(view)).fill(77);
    writeView(view, floats);
    expect([...floats.subarray(0, 4)]).toEqual([1, 0.25, 1, 0.5]);
    expect([...floats.subarray(VIEW_OFFSETS.clipFromWorld, VIEW_OFFSETS.direction)]).toEqual(view.clipFromWorld);
    expect(floats[VIEW_OFFSETS.direction + 2]).toBeCloseTo(0.8);
    const [head, coverage] = [
      [1.5, -1, -2, -3, 1, 2, 3],
      [0.125, -4, 50, 2, 0.0625, 3, 1, 0.75, -0.5, 0.5, 1.25],
    ];
    const lifters = [1, 6, 5, 4, 3, 2, 1, ...Array<number>(42).fill(0)];
    const tables = [9, 8, 7, 0.25, 0.375];
    expect([...floats.subarray(VIEW_OFFSETS.reach)]).toEqual([...head, ...coverage, 4, ...lifters, 1, ...tables]);
  });

  it('matches what Rust reads from each part of a view', async () => {
    const simulator = (await loadVariant('core')).create({ capacity: 64, seed: 1 });
    simulator.set({ ...JET, 'emitters.0.position.x': 5 });
    simulator.step(10);
    const culled = { ...EVERYTHING, cull: true };
    expect(simulator.arrange(EVERYTHING).rows.count).toBeGreaterThan(50);
    // Clip space equals world space here, so positions with x = 5 are to the right of the view.
    expect(simulator.arrange(culled).rows.count).toBe(0);
    const wide = Array.from(EVERYTHING.clipFromWorld);
    wide[0] = 0.1;
    expect(simulator.arrange({ ...culled, clipFromWorld: wide }).rows.count).toBeGreaterThan(50);
    simulator.dispose();
  });

  it('unpacks the attributes of a row', async () => {
    const simulator = (await loadVariant('core')).create({ capacity: 64, seed: 1 });
    simulator.set({
      ...JET,
      'emitters.0.lifetimeVariation': 0,
      'puff.variations': 5,
      'emitters.0.temperature': 2,
      'buoyancy.coolingTime': 1e3,
    });
    simulator.step(20);
    const { count, attributes } = simulator.arrange(EVERYTHING).rows;
    const rows = Array.from({ length: count }, (_, index) => readAttributes(attributes, index));
    expect(new Set(rows.map((row) => row.variation))).toEqual(new Set([0, 1, 2, 3, 4]));
    expect(new Set(rows.map((row) => row.seed)).size).toBeGreaterThan(20);
    for (const row of rows) {
      expect(row.age).toBeGreaterThanOrEqual(0);
      expect(row.age).toBeLessThan(21 / 60 / 4);
      expect(row.temperature).toBeGreaterThan(1.9);
      expect(row.temperature).toBeLessThan(2.1);
      expect(row.roll).toBeLessThan(1);
    }
    expect(TEMPERATURE_MAX).toBe(4);
    simulator.dispose();
  });
});
