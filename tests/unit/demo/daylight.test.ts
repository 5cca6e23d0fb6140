/** Light and backdrop by the hour, for every preset. */
import { expect, test } from 'vitest';
import { daylight, dayOf, DAYLIGHT_KEYS, OWN_HOUR } from '../../../src/demo/panel/daylight.ts';
import { decode, encode, findParameter, presets, presetValues, validate, type Values } from '../../../src/preset.ts';
import { blendedAt, inLight, linear, type Color, type Tone } from '../../../src/renderer/gpu/ramps.ts';
import { parseStops, plainColorOf, rampOf } from '../../../src/renderer/palette.ts';
import { inkOf, styleOf } from '../../../src/renderer/style.ts';

const SCENE = '0:fae2ce,1:569ed8';
const QUARTERS = Array.from({ length: 97 }, (_, quarter) => quarter / 4);
const at = (hour: number, own: Values, scene = SCENE) => daylight(hour, own, scene) as Values;
const ownOf = (values: Values) => Object.fromEntries(DAYLIGHT_KEYS.map((key) => [key, values[key]]));

/** What a picture shows of the values, as numbers: degrees, channels, and strengths in hundredths. */
function shownOf(values: Values): number[] {
  const backdrop: Tone[] = parseStops(values['style.backdrop'] || SCENE);
  const angle = (values['light.azimuth']! * Math.PI) / 180;
  const channels = (key: 'light.color' | 'light.ambientColor') =>
    [1, 3, 5].map((start) => Number.parseInt(values[key]!.slice(start, start + 2), 16));
  return [
    57.3 * Math.sin(angle),
    57.3 * Math.cos(angle),
    values['light.elevation']!,
    ...channels('light.color'),
    ...channels('light.ambientColor'),
    ...(['light.intensity', 'light.ambient', 'style.inkLight'] as const).map((key) => 100 * values[key]!),
    ...[0, 0.25, 0.5, 0.75, 1].flatMap((height) => blendedAt(backdrop, height)),
  ];
}

test('the own hour has exactly the values of the preset', () => {
  for (const { values } of presets) {
    const own = presetValues({ values });
    expect(at(OWN_HOUR, own)).toEqual(ownOf(own));
  }
});

test('nothing jumps in 24 hours, at midnight and at the own hour included', () => {
  for (const { name, values } of presets) {
    const own = presetValues({ values });
    for (let minute = 0; minute < 24 * 60; minute += 2) {
      const [before, after] = [minute, minute + 2].map((each) => shownOf(at((each % 1440) / 60, own)));
      const steps = before.map((value, index) => Math.abs(value - after[index]));
      expect(Math.max(...steps), `${name} at minute ${minute}`).toBeLessThan(9);
    }
    expect(at(24, own)).toEqual(at(0, own));
  }
});

test('every hour is valid, has a light above the horizon, and survives a link', async () => {
  for (const { name } of presets) {
    const own = presetValues(name);
    for (const hour of QUARTERS) {
      const values = at(hour, own);
      expect(() => validate(values), `${name} at ${hour}`).not.toThrow();
      expect(values['light.elevation']).toBeGreaterThanOrEqual(5);
      if (hour % 3 !== 0) continue;
      const state = { preset: name, values: { ...own, ...values } };
      expect((await decode(await encode(state))).state).toEqual(state);
    }
  }
  expect(findParameter('light.elevation')).toMatchObject({ min: 5 });
});

test('night is dimmer and bluer than day, and dusk warmer', () => {
  const own = presetValues('cloudscape');
  const warmth = (values: Values) => {
    const [red, , blue] = linear(parseStops(`0:${values['light.color']!.slice(1)},1:000000`)[0].color);
    return red / blue;
  };
  const [dusk, night] = [at(18.5, own), at(0, own)];
  expect(warmth(dusk)).toBeGreaterThan(2);
  expect(warmth(night)).toBeLessThan(0.6);
  for (const key of ['light.intensity', 'light.ambient'] as const) expect(night[key]).toBeLessThan(0.85 * own[key]!);
});

test('a lamp keeps its place and strength, and fire its light', () => {
  const lamp = presetValues({ values: { 'light.kind': 'lamp', 'light.color': '#ffcc88', 'light.intensity': 1.5 } });
  const night = at(0, lamp);
  for (const key of ['light.azimuth', 'light.elevation', 'light.color', 'light.intensity'] as const)
    expect(night[key], key).toBe(lamp[key]);
  expect(night['light.ambient']).toBeLessThan(0.75);

  const fire = presetValues('campfire');
  const { 'light.color': color, 'light.ambient': ambient, 'style.backdrop': backdrop } = at(0, fire);
  expect([color, ambient]).toEqual([fire['light.color'], fire['light.ambient']]);
  expect(backdrop).not.toBe(at(12, fire)['style.backdrop']);
});

test('fire that glows is in the dark at night, and in the light of its preset at the own hour', () => {
  for (const name of ['campfire-night', 'rocket-night'] as const) {
    const day = dayOf(name);
    const glowing = { ...day, 'emission.glow': presetValues(name)['emission.glow'] };
    const night = at(0, glowing);
    for (const key of ['light.intensity', 'light.ambient'] as const)
      expect(night[key], `${name}: ${key}`).toBeLessThan(0.85 * day[key]!);
    expect(at(OWN_HOUR, glowing)).toEqual(ownOf(day));
    expect(at(0, { ...day, 'emission.glow': '0:0,1:0' })['light.ambient']).toBe(day['light.ambient']);
  }
});

test('the backdrop of a preset with its own colours goes with the hour, too', () => {
  const own = presetValues('lamp-wind-waker');
  const scene = at(0, own, '0:000000,1:ffffff')['style.backdrop'];
  expect(scene).toBe(at(0, own)['style.backdrop']);
  expect(scene).not.toBe(own['style.backdrop']);
  const sky = (hour: number) => lightness(parseStops(at(hour, own)['style.backdrop']!)[0].color);
  expect(sky(0)).toBeLessThan(0.3 * lightness(parseStops(own['style.backdrop']!)[0].color));
});

test('dark ink stays darker than smoke in shadow at every hour', () => {
  let count = 0;
  for (const { name } of presets) {
    const own = presetValues(name);
    if (contrast(own) < 2 || own['style.outlines'] === 0) continue;
    count += 1;
    for (const hour of QUARTERS)
      expect(contrast({ ...own, ...at(hour, own) }), `${name} at ${hour}`).toBeGreaterThan(1.05);
  }
  expect(count).toBeGreaterThan(15);
});

test('hours of dusk and night looks are relative to the look by day', () => {
  expect(dayOf('cloudscape')).toEqual(presetValues('cloudscape'));
  expect(dayOf('train-night-mail')).toEqual(presetValues('train-night-mail'));
  expect(dayOf('cloudscape-night')).toEqual(presetValues('cloudscape'));
  expect(dayOf('train-dusk')).toEqual(presetValues('train'));
  expect(dayOf('campfire-night')).toEqual(presetValues('campfire'));
});

/** Lightness of smoke in shadow by that of ink, in linear light; a little is added to both, as of a screen in a room. */
function contrast(values: Values): number {
  const style = styleOf(values);
  const { unlit } = rampOf(plainColorOf(style), style);
  const shadow = inLight(unlit[0].color, unlit[0].color, style.illumination);
  return (lightness(shadow) + 0.005) / (lightness(inkOf(style)) + 0.005);
}

function lightness(color: Color): number {
  const [red, green, blue] = linear(color);
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}
