import { describe, expect, it } from 'vitest';
import { readEnvironment } from '../../../src/parameters/environment.ts';
import { ParameterError } from '../../../src/base/errors.ts';
import type { ChoiceParameter, NumberParameter } from '../../../src/parameters/parameter.ts';
import { fetchPreset, FIRST_PRESET } from '../../../src/parameters/byScene/fetchPreset.ts';
import { defaultPreset, findPreset, presets, presetValues } from '../../../src/parameters/presets.ts';
import { readTimeline, writeTimeline } from '../../../src/parameters/timeline.ts';
import { defaults, isAccepted, validate } from '../../../src/parameters/values.ts';
import { itemGroups } from '../../../src/parameters/words/lists.ts';
import { findParameter, groups, table } from '../../../src/parameters/words/table.ts';
import type { WordsOf } from '../../../src/parameters/words/words.ts';
import { sceneNamed } from '../../../src/scenes/scenes.ts';

/** Public names, used by links and pages. */
const PROMISED = [
  'scene',
  'seed',
  'emission.rate',
  'emission.lifetime',
  'simulation.maxParticles',
  'forces.gravity',
  'forces.buoyancy',
  'forces.turbulence',
  'forces.vortex',
  'forces.drag',
  'forces.wind.x',
  'forces.wind.y',
  'forces.wind.z',
  'puff.size',
  'style.shading',
  'style.outlines',
  'style.shadows',
  'style.gradient',
  'style.outlineWidth',
  'style.tones',
  'style.smokeColor',
  'style.inkColor',
  'style.renderer',
  'light.azimuth',
  'light.elevation',
];

describe('presets that are loaded separately', () => {
  it.each(presets.map(({ name }) => name))('%s loaded separately equals the one in the list', async (name) => {
    expect(await fetchPreset(name)).toBe(findPreset(name));
  });

  it('do not exist for an unknown name, which shows the first one', async () => {
    for (const name of ['', 'nobody', 'wisp-nobody', 'constructor', '__proto__']) {
      expect(await fetchPreset(name)).toBeUndefined();
    }
    expect(defaultPreset.name).toBe(FIRST_PRESET);
  });
});

describe('table', () => {
  it('has every documented key once, each with a group', () => {
    const keys = table.map(({ key }) => key);
    expect(keys).toEqual(expect.arrayContaining(PROMISED));
    expect(new Set(keys).size).toBe(keys.length);
    for (const row of table) expect([...groups, ...itemGroups].map(({ key }) => key)).toContain(row.group);
  });

  it('has valid defaults that sliders can reach', () => {
    for (const row of table) {
      expect(isAccepted(row, row.default), row.key).toBe(true);
      if (row.kind === 'number' || row.kind === 'integer')
        expect(row.min + row.step, row.key).toBeLessThanOrEqual(row.max);
    }
  });

  it('has one sentence for every row', () => {
    for (const { key, label, text } of table) {
      expect(label, key).not.toBe('');
      expect(text, key).toMatch(/^[A-Z].*\.$/);
    }
  });

  it('has words that compile for exactly its rows, their kinds and their options', () => {
    type Number = { kind: 'number'; key: 'style.rim' } & NumberParameter;
    type Choice = { kind: 'choice'; key: 'style.volumes' } & ChoiceParameter;
    type Checked = WordsOf<[Number, Choice]>;
    const words = { label: 'Rim', text: 'A rim.' };
    const rim = { 'style.rim': { ...words, step: 1 } };
    const volumes = { 'style.volumes': { ...words, options: { receiver: 'One', counted: 'Two' } } };
    const accepted: Checked = { ...rim, ...volumes };
    const rejected: Checked[] = [
      // @ts-expect-error no words of the choice
      { ...rim },
      // @ts-expect-error no step of the number
      { ...volumes, 'style.rim': words },
      // @ts-expect-error no words of an option
      { ...rim, 'style.volumes': { ...words, options: { receiver: 'One' } } },
      // @ts-expect-error no such row
      { ...rim, ...volumes, 'style.ring': words },
      // @ts-expect-error no such option
      { ...rim, 'style.volumes': { ...words, options: { receiver: 'One', counted: 'Two', both: 'Three' } } },
    ];
    expect(rejected).not.toContainEqual(accepted);
  });

  it('has keys that need no escaping in links', () => {
    for (const { key } of table) expect(encodeURIComponent(key)).toBe(key);
  });

  it('finds nothing by keys of the object prototype', () => {
    for (const key of ['__proto__', 'constructor', '']) expect(findParameter(key)).toBeUndefined();
  });
});

describe('presets', () => {
  it('have unique names and valid values within the limits for links', () => {
    expect(new Set(presets.map(({ name }) => name)).size).toBe(presets.length);
    for (const preset of presets) {
      expect(() => validate(preset.values)).not.toThrow();
      expect(presetValues(preset)['simulation.maxParticles']).toBeLessThanOrEqual(50_000);
      expect(findPreset(preset.name)).toBe(preset);
    }
    expect(defaultPreset.name).toBe('lamp');
  });

  it('fit into the capacity of the simulator', async () => {
    for (const preset of presets) {
      const values = presetValues(preset) as Record<string, number>;
      const { rule } = await sceneNamed(values.scene as unknown as string).load();
      // The tests of scenes with a rule cover the share of the rate that the rule uses.
      if (rule) continue;
      const alive = values['emission.rate'] * values['emission.lifetime'];
      expect(alive, preset.name).toBeLessThan(values['simulation.maxParticles']);
    }
  });
});

describe('validate', () => {
  it('accepts both ends of every range and nothing beyond', () => {
    for (const row of table) {
      if (row.kind !== 'number' && row.kind !== 'integer') continue;
      for (const value of [row.min, row.max]) expect(() => validate({ [row.key]: value })).not.toThrow();
      for (const value of [row.min - row.step, row.max + row.step, Number.NaN, Infinity, -Infinity]) {
        expect(() => validate({ [row.key]: value }), `${row.key} ${value}`).toThrow(ParameterError);
      }
    }
  });

  it('names the parameter, the value and the accepted values', () => {
    expect(() => validate({ 'emission.rate': -1 })).toThrow(
      'emission.rate cannot be -1: it takes a number from 0 to 20000 particles/s.',
    );
    expect(() => validate({ 'emission.rate': '60' })).toThrow('emission.rate cannot be “60”: it takes a number from 0');
    expect(() => validate({ 'style.gradient': 'rainbow' })).toThrow('none, puff, height, screen, age');
    expect(() => validate({ 'emission.rats': 1 })).toThrow(
      'emission.rats cannot be 1: it takes no value (no such parameter).',
    );
  });

  it('rejects values that only look valid', () => {
    const wrong: [string, unknown][] = [
      ['emission.rate', '240'],
      ['seed', 1.5],
      ['style.shadows', true],
      ['style.tones', '2'],
      ['style.tones', 4],
      ['style.inkColor', 'red'],
      ['style.inkColor', '#fff'],
      ['style.inkColor', 0],
      ['__proto__x', 1],
      ['toString', 1],
    ];
    for (const [key, value] of wrong) {
      expect(() => validate({ [key]: value as number }), key).toThrow(ParameterError);
    }
  });

  it('accepts the defaults', () => {
    expect(() => validate(defaults())).not.toThrow();
  });
});

describe('readEnvironment', () => {
  it('has defaults without notices', () => {
    expect(readEnvironment('')).toEqual({
      paused: false,
      time: undefined,
      hasInterface: true,
      hasStatistics: false,
      quality: 'auto',
      view: undefined,
      notices: [],
    });
  });

  it('reads the four flags', () => {
    const { paused, time, hasInterface, hasStatistics } = readEnvironment('?paused=1&t=2.5&ui=0&stats=1&other=x');
    expect([paused, time, hasInterface, hasStatistics]).toEqual([true, 2.5, false, true]);
  });

  it('clamps the time, with a notice', () => {
    for (const [text, time] of [
      ['601', 600],
      ['1' + '0'.repeat(400), 600],
      ['-1', 0],
    ] as const) {
      const read = readEnvironment(`?t=${text}`);
      expect(read.time).toBe(time);
      expect(read.notices.map(({ code }) => code)).toEqual(['outOfRange']);
    }
  });

  it('reads a view, or lists the valid ones', () => {
    expect(readEnvironment('?view=depth')).toMatchObject({ view: 'depth', notices: [] });
    const { view, notices } = readEnvironment('?view=constructor');
    expect(view).toBeUndefined();
    expect(notices[0].message).toContain('normals');
  });

  it('reads, clamps or ignores the quality', () => {
    for (const [text, quality, codes] of [
      ['auto', 'auto', []],
      ['.75', 0.75, []],
      ['0', 0.25, ['outOfRange']],
      ['7', 1, ['outOfRange']],
      ['best', 'auto', ['malformed']],
    ] as const) {
      const read = readEnvironment(`?quality=${text}`);
      expect(read.quality).toBe(quality);
      expect(read.notices.map(({ code }) => code)).toEqual(codes);
    }
  });

  it('ignores an invalid time, with a notice', () => {
    for (const text of ['', 'soon', 'NaN', 'Infinity', '1e2', '.']) {
      const read = readEnvironment(`?t=${text}`);
      expect(read.time).toBeUndefined();
      expect(read.notices.map(({ code }) => code)).toEqual(['malformed']);
    }
  });
});

// Otherwise a stage would show another preset as changed.
describe('the timeline of a preset is written as a stage returns it', () => {
  const timelines = presets.flatMap(({ name, values }) => (values.timeline ? [{ name, text: values.timeline }] : []));
  it.each(timelines)('$name', ({ text }) => {
    const { timeline, problems } = readTimeline(text);
    expect(problems).toEqual([]);
    expect(writeTimeline(timeline)).toBe(text);
  });
});
