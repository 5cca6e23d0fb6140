import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { ATTRIBUTE_BITS, END_STEPS, LIFTERS_LIMIT, VIEW_FLOATS, VIEW_OFFSETS } from '../../../src/simulator/layout.ts';
import { readAttributes } from '../../../src/simulator/rows.ts';
import { viewLength, writeView, type View } from '../../../src/simulator/view.ts';
import { EVERYTHING } from '../../support/sim/everything.ts';
import { JET, loadVariant } from '../../support/sim/simWasm.ts';

const SHADERS = new URL('../../../shaders/', import.meta.url);

/** The fields of packed attributes that a shader reads, by the name of the function without `Of`. */
function fieldsIn(file: string): [name: string, { word: number; shift: number; max: number }][] {
  const source = readFileSync(new URL(file, SHADERS), 'utf8');
  const reads = /(\w+?)(?:Of)?\([^()]*\) \{(?:(?!^\})[^])*?^\}/gm;
  return [...source.matchAll(reads)].flatMap(([body, name]) =>
    [...body.matchAll(/\battributes\.([xy])\b(?: >> (\d+)u)?\)?(?: & (0x[0-9a-f]+)u)?/g)].map(
      ([, component, shift = '0', mask]): ReturnType<typeof fieldsIn>[number] => {
        const word = 'xy'.indexOf(component);
        return [name, { word, shift: Number(shift), max: mask ? Number(mask) : 2 ** (32 - Number(shift)) - 1 }];
      },
    ),
  );
}

describe('the layout of rows and views', () => {
  it('writes each part of a view at its own offset', () => {
    const view: View = {
      purpose: 'light',
      blend: 0.25,
      cull: true,
      pad: 0.5,
      clipFromWorld: Array.from({ length: 16 }, (_, index) => 100 + index),
      direction: [0, -0.625, 0.75],
      lamp: [7, 8, -9],
      reach: 1.5,
      sides: 8,
      upright: 0.625,
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
        solids: { table: new Float32Array([9, 8, 7]), balls: 4, facesEye: 1, tolerance: 0.0625, blur: 3 },
      },
    };
    const floats = new Float32Array(viewLength(view)).fill(77);
    writeView(view, floats);
    const parts: Record<keyof typeof VIEW_OFFSETS, number[]> = {
      purpose: [2],
      lamp: [7, 8, -9],
      blend: [0.25],
      cull: [1],
      pad: [0.5],
      clipFromWorld: Array.from(view.clipFromWorld),
      direction: [0, -0.625, 0.75],
      reach: [1.5],
      receivers: [-1, -2, -3, 1, 2, 3],
      pixel: [0.125],
      nearest: [-4],
      farthest: [50],
      covers: [2],
      tolerance: [0.0625],
      blur: [3],
      facesEye: [1],
      lift: [0.75],
      capRange: [-0.5, 0.5],
      depth: [1.25],
      balls: [4],
      lifters: [1],
      lifterBoxes: [6, 5, 4, 3, 2, 1, ...Array<number>(6 * (LIFTERS_LIMIT - 1)).fill(0)],
      capsFollow: [1],
      sides: [8],
      upright: [0.625],
    };
    for (const [name, numbers] of Object.entries(parts)) {
      const offset = VIEW_OFFSETS[name as keyof typeof parts];
      expect([...floats.subarray(offset, offset + numbers.length)], name).toEqual(numbers);
    }
    expect(Object.values(parts).flat().length).toBe(VIEW_FLOATS);
    expect([...floats.subarray(VIEW_FLOATS)]).toEqual([9, 8, 7, 0.25, 0.375]);
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

  it('is the one that shaders read', () => {
    const { temperature, look, ...others } = ATTRIBUTE_BITS;
    // Words 2 and 3 are read as vectors; pictures of deformed puffs show whether they match.
    const words = Object.entries(others).filter(([, { word }]) => word < 2);
    expect(Object.fromEntries(fieldsIn('lib/attributes.glsl'))).toEqual(Object.fromEntries(words));
    // The ramps have 256 ages.
    const age = { ...others.age, shift: others.age.shift + 8, max: 0xff };
    expect(fieldsIn('lib/material.glsl').map(([, bits]) => bits)).toEqual([age, temperature]);
    expect(fieldsIn('looks/looks.glsl')).toEqual([['look', look]]);
    const files = readdirSync(SHADERS, { recursive: true, encoding: 'utf8' }).filter((file) => /\.\w+$/.test(file));
    const readers = files.filter((file) => fieldsIn(file).length > 0).sort();
    expect(readers).toEqual(['lib/attributes.glsl', 'lib/material.glsl', 'looks/looks.glsl']);

    const source = readFileSync(new URL('lib/attributes.glsl', SHADERS), 'utf8');
    expect(source).toContain(`& 0x${others.roll.max.toString(16)}u) * (6.28318530718 / ${others.roll.max + 1}.0)`);
    expect(source).toContain(`>> ${others.age.shift}u) / ${others.age.max}.0`);
    expect(source).toContain(`end == 0x${others.end.max.toString(16)}u ? 1e9 : float(end) / ${END_STEPS}.0`);
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
    simulator.dispose();
  });
});
