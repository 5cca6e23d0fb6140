import { describe, expect, it } from 'vitest';
import { withPlace } from '../../../src/demo/panel/rampControl.ts';
import { decode } from '../../../src/parameters/codec.ts';
import { ParameterError } from '../../../src/base/errors.ts';
import { MAX_COLORS, readRamp, writeRamp } from '../../../src/parameters/ramp.ts';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { validate } from '../../../src/parameters/values.ts';

const TEXT = '0:333344,.5:aab0c0,1:ffffff';

/** A number of stops at even distances. */
function stopsText(count: number): string {
  return Array.from({ length: count }, (_, index) => `${(index / 100).toFixed(2).replace(/^0/, '')}:00ff00`).join();
}

describe('ramps', () => {
  it('are read as written', () => {
    expect(readRamp(TEXT)).toEqual([
      { at: 0, color: '#333344' },
      { at: 0.5, color: '#aab0c0' },
      { at: 1, color: '#ffffff' },
    ]);
    expect(writeRamp(readRamp(TEXT)!)).toBe(TEXT);
    expect(readRamp(' 0.25:ABCDEF , 1.0:000000')).toEqual([
      { at: 0.25, color: '#abcdef' },
      { at: 1, color: '#000000' },
    ]);
  });

  it('can be empty', () => {
    expect(readRamp('')).toEqual([]);
  });

  it.each([
    '0:fff,1:000',
    '0:ffffff',
    '1:ffffff,0:000000',
    '0:ffffff,0:000000',
    '0:ffffff,2:000000',
    '0:ffffff,1:#00000',
  ])('are rejected if malformed: %s', (text) => expect(readRamp(text)).toBeUndefined());

  it('have at most 16 stops', () => {
    expect(readRamp(stopsText(MAX_COLORS))).toHaveLength(16);
    expect(readRamp(stopsText(MAX_COLORS + 1))).toBeUndefined();
  });

  it('are checked by name when a caller sets them', () => {
    expect(() => validate({ 'style.ramp': TEXT, 'style.heatRamp': '' })).not.toThrow();
    expect(() => validate({ 'style.ramp': '0:red,1:blue' })).toThrow(ParameterError);
    expect(() => validate({ 'style.ageRamp': 3 })).toThrow('2 to 16 stops such as 0:333344');
  });

  it('of a link fall back to the preset with a notice where they are malformed', async () => {
    const good = await decode(`#v=1&preset=lamp-ember&style.ramp=${TEXT}`);
    expect(good.notices).toEqual([]);
    expect(good.state.values['style.ramp']).toBe(TEXT);
    const { state, notices } = await decode('#v=1&preset=lamp-ember&style.heatRamp=0:<b>,1:ffffff&style.ramp=0:1');
    expect(state.values['style.ramp']).toBe(presetValues(findPreset('lamp-ember')!)['style.ramp']);
    expect(readRamp(String(state.values['style.heatRamp']))!.length).toBeGreaterThan(2);
    expect(notices.map(({ code, key }) => `${code} ${key}`)).toEqual([
      'malformed style.heatRamp',
      'malformed style.ramp',
    ]);
  });

  it('keep the order of their stops while one is moved', () => {
    const stops = readRamp('0:000000,.5:888888,1:ffffff')!;
    expect(withPlace(stops, 1, 2)[1]).toEqual({ at: 0.999, color: '#888888' });
    expect(withPlace(stops, 0, -1)[0].at).toBe(0);
    expect(withPlace(stops, 2, 0.1)[2].at).toBe(0.501);
  });
});
