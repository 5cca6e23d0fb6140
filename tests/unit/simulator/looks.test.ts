/** Looks of emitters as numbers: packed curves, numbered styles, and what saved states have of them. */
import { beforeAll, describe, expect, it } from 'vitest';
import type { AnyValues } from '../../../src/parameters/parameter.ts';
import { readText } from '../../../src/parameters/values.ts';
import { findParameter, table } from '../../../src/parameters/table.ts';
import { emissionNumbers, emitterNumbers, tableValues } from '../../../src/simulator/emitterOptions.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import {
  NO_STYLE,
  numberOfStyle,
  numbersOfStyles,
  styleOfNumber,
  stylesOf,
} from '../../../src/simulator/lookStyles.ts';
import { savedLooks, splitState, withMetadata, withSavedLooks } from '../../../src/simulator/savedState.ts';
import { simulatorValues, valuesIn } from '../../../src/simulator/simulatorValues.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

let factory: SimulatorFactory;
beforeAll(async () => {
  factory = await loadVariant('core');
});

const RED = '0:400000,.5:ff4030';
const BLUE = '0:000040,.5:4030ff';
const STYLED = { ...NO_STYLE, colors: RED, inkWeight: 2 };

const numbered = (numbers: Readonly<Record<string, number>>, end: string) =>
  Object.fromEntries(Object.entries(numbers).filter(([key]) => key.startsWith(`emitters.0.look.${end}`)));

describe('values', () => {
  it('pack each stop of a curve into one number, and no stop into 0', () => {
    const numbers = simulatorValues({ 'emitters.0.look.sizeCurve': '0:1,.5:.2,1:0' });
    expect(numbered(numbers, 'sizeCurve')).toEqual({
      'emitters.0.look.sizeCurve.0': 1 + 131072 * 65535,
      'emitters.0.look.sizeCurve.1': 1 + 32768 + 131072 * 13107,
      'emitters.0.look.sizeCurve.2': 1 + 65535,
      ...Object.fromEntries([3, 4, 5, 6, 7].map((stop) => [`emitters.0.look.sizeCurve.${stop}`, 0])),
    });
    expect(Object.values(simulatorValues({ 'emitters.0.look.sizeCurve': '' }))).toEqual(Array(8).fill(0));
  });

  it('number the colours and the ink of an emitter by the emitter', () => {
    const style = (values: AnyValues, all?: AnyValues) => simulatorValues(values, all)['emitters.5.look.style'];
    expect(style({ 'emitters.5.look.colors': RED })).toBe(6);
    expect(style({ 'emitters.5.look.inkWeight': 0 })).toBe(6);
    expect(style({ 'emitters.5.look.colors': '', 'emitters.5.look.inkWeight': 1 })).toBe(0);
    expect(style({ 'emitters.5.speed': 1 })).toBeUndefined();
    const rest = { 'emitters.5.look.ageColors': BLUE };
    expect(style({ 'emitters.5.look.colors': '' }, { ...rest, 'emitters.5.look.colors': '' })).toBe(6);
    expect(style({ 'emitters.5.look.colors': '' }, { 'emitters.5.look.colors': '' })).toBe(0);
  });

  it('come back from the simulator as they were', () => {
    const values = {
      'emitters.2.perMetre': 3,
      'emitters.2.look.lifetime': 2,
      'emitters.2.look.sizeCurve': '0:.25,.333:1,1:.125',
      'emitters.2.look.dissolve': 'tear',
      'emitters.2.look.colors': RED,
    } as const;
    const simulator = factory.create({ capacity: 4, seed: 1 });
    simulator.set(simulatorValues(values));
    expect(valuesIn(simulator, values, {})).toMatchObject(values);
    // Those of another stage: the simulator knows neither the texts nor the colours.
    const { 'emitters.2.look.colors': _, ...others } = values;
    expect(valuesIn(simulator, {}, {})).toMatchObject({
      ...others,
      'emitters.2.look.sizeCurve': '0:.25,.333:1,1:.125',
    });
    simulator.set(simulatorValues({ 'emitters.2.look.sizeCurve': '', 'emitters.2.look.colors': '' }));
    const after = valuesIn(simulator, values, {});
    expect(after).not.toHaveProperty('emitters.2.look.sizeCurve');
    expect(after).not.toHaveProperty('emitters.2.look.colors');
    expect(after).toMatchObject({ 'emitters.2.look.lifetime': 2 });
    simulator.dispose();
  });

  it('keep a default that is set, and drop those of an item that the simulator lacks', () => {
    const simulator = factory.create({ capacity: 4, seed: 1 });
    const values = { 'emitters.1.speed': 2, 'emitters.1.perMetre': 0, 'emitters.6.perMetre': 4 } as const;
    simulator.set(simulatorValues({ 'emitters.1.speed': 2, 'emitters.1.perMetre': 0 }));
    const after = valuesIn(simulator, values, {});
    expect(after).toMatchObject({ 'emitters.1.speed': 2, 'emitters.1.perMetre': 0 });
    expect(after).not.toHaveProperty('emitters.6.perMetre');
    simulator.dispose();
  });

  it('of links are clamped or dropped with a notice', () => {
    const read = (name: string, text: string) => readText(findParameter(`emitters.0.look.${name}`)!, text);
    expect(read('inkWeight', '1e9')).toMatchObject({ value: 4, notice: { code: 'outOfRange' } });
    expect(read('lifetime', '-3')).toMatchObject({ value: 0, notice: { code: 'outOfRange' } });
    for (const text of ['x', '0:1', '1:1,0:0', '0:1,.5:7', `${'0:1,'.repeat(9)}1:1`])
      expect(read('sizeCurve', text), text).toMatchObject({ value: '', notice: { code: 'malformed' } });
    expect(read('sizeCurve', '')).toEqual({ value: '' });
    expect(read('colors', '0:zzz')).toMatchObject({ value: '', notice: { code: 'malformed' } });
    expect(read('dissolve', 'melt')).toMatchObject({ value: 'smoke', notice: { code: 'malformed' } });
    expect(readText(findParameter('emission.density')!, '')).toMatchObject({ notice: { code: 'malformed' } });
  });

  it('have no rows of packed stops and of the number of the style', () => {
    const keys = table.map(({ key }) => key).filter((key) => key.startsWith('emitters.0.look.'));
    expect(keys.map((key) => key.slice('emitters.0.look.'.length)).sort()).toEqual(
      'ageColors buoyancy colors densityCurve dissolve drag gravity growthTime heatColors inkWeight lifetime sizeCurve'.split(
        ' ',
      ),
    );
  });
});

describe('numbers of styles', () => {
  it('are hashes of the content, the same in every session', () => {
    expect(numberOfStyle(STYLED)).toBe(numberOfStyle({ ...STYLED }));
    expect(numberOfStyle(STYLED)).not.toBe(numberOfStyle({ ...STYLED, inkWeight: 1 }));
    expect(numberOfStyle(STYLED)).toBe(249066519);
    expect(styleOfNumber(numberOfStyle(STYLED))).toEqual(STYLED);
    expect(styleOfNumber(17)).toBeUndefined();
  });

  it('are those of looks outside the table only', () => {
    const styleIn = (numbers: Float64Array) => numbers.at(-1);
    expect(styleIn(emitterNumbers('emitFrom', {}))).toBe(0);
    expect(styleIn(emitterNumbers('emitFrom', { look: { lifetime: 2 } }))).toBe(0);
    expect(styleIn(emitterNumbers('emitFrom', { look: { colors: RED, inkWeight: 2 } }))).toBe(numberOfStyle(STYLED));
    const position = { x: 0, y: 0, z: 0 };
    expect(styleIn(emissionNumbers({ position, count: 1, look: STYLED }))).toBe(numberOfStyle(STYLED));
    expect(tableValues('emitFrom', 3, { look: { colors: RED } })).toMatchObject({
      'emitters.3.look.colors': RED,
      'emitters.3.look.lifetime': 0,
      'emitters.3.look.dissolve': 'smoke',
    });
  });

  it('follow a look that replaces another', () => {
    const before = emitterNumbers('emitFrom', { look: { colors: RED, gravity: 3 } });
    expect(emitterNumbers('emitFrom', { look: {} }, before)).toEqual(emitterNumbers('emitFrom', {}));
    expect(emitterNumbers('emitFrom', { size: 0.3 }, before)).toEqual(before);
  });

  it('are written up to a limit, the latest first', () => {
    const colors = (index: number) => `0:${index.toString(16).padStart(6, '0')},1:ffffff`;
    const numbers = Array.from({ length: 1000 }, (_, index) => numberOfStyle({ ...NO_STYLE, colors: colors(index) }));
    const written = stylesOf(numbers);
    expect(JSON.stringify(written).length).toBeLessThan(17_000);
    expect(written.length).toBeGreaterThan(150);
    expect(written.at(-1)?.colors).toBe(colors(999));
  });

  it('of untrusted data are those of what is sound', () => {
    const hostile = [null, 7, 'x', [], {}, { colors: 5, inkWeight: Infinity }, { colors: '0:zz', heatColors: BLUE }];
    const styles = numbersOfStyles(hostile).map(styleOfNumber);
    expect(styles).toEqual([...Array(6).fill(NO_STYLE), { ...NO_STYLE, heatColors: BLUE }]);
    for (const wrong of [undefined, null, {}, 'looks']) expect(numbersOfStyles(wrong)).toEqual([]);
  });
});

describe('a saved state', () => {
  const state = Uint8Array.of(1, 2, 3, 250);
  const values = { 'emitters.1.look.colors': RED, 'emitters.1.speed': 3, 'style.smokeColor': '#ffffff' } as const;

  it('has the styles and the colours of looks after the bytes of the simulator', () => {
    const bytes = withSavedLooks(state, [numberOfStyle(STYLED)], values);
    const found = splitState(bytes);
    expect([...found.state]).toEqual([...state]);
    expect(numbersOfStyles(found.meta.styles)).toEqual([numberOfStyle(STYLED)]);
    expect(savedLooks(bytes)).toEqual({ 'emitters.1.look.colors': RED });
    expect(splitState(state)).toEqual({ state, meta: {} });
  });

  it('has what people hold of a timeline beside the looks', () => {
    const bytes = withMetadata(withSavedLooks(state, [], values), { held: { seed: 3 } });
    expect(splitState(bytes)).toEqual({
      state,
      meta: { styles: [], looks: { 'emitters.1.look.colors': RED }, held: { seed: 3 } },
    });
  });

  it('is split whatever the bytes are', () => {
    const bytes = withSavedLooks(state, [numberOfStyle(STYLED)], values);
    for (let at = 0; at < bytes.length; at++) {
      const damaged = bytes.slice();
      damaged[at] ^= 0x15;
      expect(() => savedLooks(damaged)).not.toThrow();
      expect(() => savedLooks(bytes.subarray(0, at))).not.toThrow();
    }
    const plain = withMetadata(state, {});
    for (const text of ['', '5', 'null', '{"looks":7}', '{"looks":{"emitters.0.look.colors":9,"scene":"air"}}']) {
      const damaged = Uint8Array.of(...state, ...new TextEncoder().encode(text), ...plain.slice(-8));
      expect([...splitState(damaged).state]).toEqual([...state]);
      expect(savedLooks(damaged)).toEqual({});
    }
  });
});
