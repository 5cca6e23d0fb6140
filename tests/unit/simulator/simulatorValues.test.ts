import { beforeAll, describe, expect, it } from 'vitest';
import { MAX_STOPS } from '../../../src/parameters/curve.ts';
import type { NumberParameter } from '../../../src/parameters/parameter.ts';
import { LIST_LIMIT, listNames } from '../../../src/parameters/lists.ts';
import { presets, presetValues } from '../../../src/parameters/presets.ts';
import { table } from '../../../src/parameters/table.ts';
import { startValues } from '../../../src/parameters/words/lists.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import type { Simulator } from '../../../src/simulator/simulator.ts';
import { EVERYTHING } from '../../support/sim/everything.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';
import { simulatorValues } from '../../../src/simulator/simulatorValues.ts';

/** One item represents its list. */
const rows = table.filter(
  (row): row is NumberParameter => row.reader === 'simulator' && 'min' in row && !/^\w+\.[1-7]\./.test(row.key),
);
/** With these values nothing spawns within 45 steps. */
const BARREN = new Set([
  'emission.rate = 0',
  'emitters.0.share = 0',
  'emitters.0.envelope.start = 3600',
  'emitters.0.envelope.fade = 60',
]);
const lamp = presetValues(presets[0]);

/** The parameter table of the page matches the simulator's. */
describe('the simulator', () => {
  let factory: SimulatorFactory;

  beforeAll(async () => {
    // The core has no rare forces.
    factory = await loadVariant('meshes');
  });

  function smoking(values: Record<string, number>): Simulator {
    const simulator = factory.create({ capacity: 256, seed: 1 });
    simulator.set({ ...simulatorValues(lamp), 'emitters.0.share': 1, 'emission.rate': 400 });
    simulator.set(values);
    simulator.step(45);
    return simulator;
  }

  it('starts with the defaults of the table', () => {
    const simulator = factory.create({ capacity: 4, seed: 1 });
    const singles = table.filter(
      ({ key, kind, reader }) => reader === 'simulator' && kind !== 'curve' && !/^\w+\.\d\./.test(key),
    );
    const defaults = Object.fromEntries(singles.map((row) => [row.key, row.default]));
    expect(Object.fromEntries(simulator.parameters())).toEqual(simulatorValues(defaults));
    simulator.dispose();
  });

  it('accepts both ends and the default of every parameter that it reads, with finite positions', () => {
    for (const row of rows) {
      for (const value of [row.min, row.default, row.max]) {
        const simulator = smoking({ [row.key]: value });
        const { count, place } = simulator.arrange(EVERYTHING).rows;
        const setting = `${row.key} = ${value}`;
        expect(place.every(Number.isFinite), setting).toBe(true);
        expect(count > 0, setting).toBe(!BARREN.has(setting));
        simulator.dispose();
      }
    }
  });

  it('accepts a vortex with an axis of zero, which a link can contain', () => {
    const axis = { 'vortices.0.axis.x': 0, 'vortices.0.axis.y': 0, 'vortices.0.axis.z': 0 };
    const simulator = smoking({ 'vortices.0.circulation': 2, ...axis });
    const { count, place } = simulator.arrange(EVERYTHING).rows;
    expect(count).toBeGreaterThan(0);
    expect(place.every(Number.isFinite)).toBe(true);
    simulator.dispose();
  });

  it('changes the rows for every parameter that it reads', () => {
    // A diagonal axis, so that a shift in any direction has an effect. Short lives, so that company matters.
    const axis = { 'vortices.0.axis.x': 0.5, 'vortices.0.axis.y': 0.5, 'emission.lifetime': 1 };
    const wind = { 'forces.wind.x': 0.5, 'wind.gusts': 0.5, 'wind.shear': 0.1 };
    const base = { ...axis, ...wind, 'vortices.0.circulation': 2, 'turbulence.speed': 1, 'gravity.acceleration': 1 };
    const shown = (values: Record<string, number>) => {
      const simulator = smoking({ ...base, ...values });
      const { place, attributes } = simulator.arrange(EVERYTHING).rows;
      const picture = `${place.join()} ${attributes.join()}`;
      simulator.dispose();
      return picture;
    };
    // The effect of a list item depends on its other values; the simulator's own tests cover each force. puff.billow only
    // has an effect on culling.
    const heeded = rows.filter(({ key }) => !/^\w+\.0\.(?!circulation)|^puff\.billow$/.test(key));
    for (const row of heeded) {
      const pictures = [row.min, row.default, row.max].map((value) => shown({ [row.key]: value }));
      expect(new Set(pictures).size, row.key).toBeGreaterThan(1);
    }
  });

  it('changes the rows for a newly added item of each list of forces', () => {
    const shown = (values: Record<string, number>) => {
      const simulator = smoking({ 'gravity.acceleration': 1, ...values });
      // Long enough for cycles of two seconds.
      simulator.step(120);
      const places = simulator.arrange(EVERYTHING).rows.place.join();
      simulator.dispose();
      return places;
    };
    const still = shown({});
    for (const list of listNames.filter((name) => name !== 'colliders')) {
      expect(shown(simulatorValues(startValues(list, 1))), list).not.toBe(still);
    }
  });

  it('has every item of every list, and no further one', () => {
    const simulator = factory.create({ capacity: 4, seed: 1 });
    const values = table.filter(({ reader }) => reader === 'simulator').map((row) => [row.key, row.default]);
    expect(() => simulator.set(simulatorValues(Object.fromEntries(values)))).not.toThrow();
    for (const key of [`vortices.${LIST_LIMIT}.circulation`, `density.${MAX_STOPS}.age`])
      expect(() => simulator.set({ [key]: 0 }), key).toThrow(key);
    simulator.dispose();
  });

  it('accepts every preset', () => {
    for (const preset of presets) {
      const values = presetValues(preset);
      expect(() => smoking(simulatorValues(values)).dispose(), preset.name).not.toThrow();
    }
  });
});
