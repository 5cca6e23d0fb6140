import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fetchValues } from '../../../src/parameters/byScene/fetchValues.ts';
import { decode, defaultState, encode, type State } from '../../../src/parameters/codec.ts';
import { migrate, type Migration } from '../../../src/parameters/migrations.ts';
import { DECODED_LIMIT, pack, packBytes } from '../../../src/parameters/packing.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { defaultPreset, presets, presetValues } from '../../../src/parameters/presets.ts';
import { findParameter, table } from '../../../src/parameters/table.ts';
import { isAccepted } from '../../../src/parameters/values.ts';
import type { PresetName } from '../../../src/parameters/valueTypes.ts';
import { expectRoundTrips } from './roundTrip.ts';

function withChanges(preset: PresetName, changes: Values): State {
  const base = presetValues(presets.find(({ name }) => name === preset)!);
  return { preset, values: { ...base, ...changes } };
}

const needed = table.filter(({ isOptional }) => !isOptional);

function expectUsable(state: State): void {
  const missing = needed.filter(({ key }) => !Object.hasOwn(state.values, key));
  const invalid = Object.entries(state.values).filter(([key, value]) => {
    const row = findParameter(key);
    return !row || !isAccepted(row, value);
  });
  // One assertion, because the tests call this thousands of times.
  const found = { isPreset: presets.some(({ name }) => name === state.preset), missing, invalid };
  expect(found).toEqual({ isPreset: true, missing: [], invalid: [] });
}

const codes = async (hash: string) => (await decode(hash)).notices.map(({ code }) => code);

describe('encode', () => {
  it('writes version, preset and what differs, in the order of the table', async () => {
    const state = withChanges('lamp', { 'style.outlineWidth': 3, 'emission.rate': 240, 'style.smokeColor': '#FFEEDD' });
    const hash = await encode(state);
    expect(hash).toBe('#v=1&preset=lamp&emission.rate=240&style.smokeColor=ffeedd&style.outlineWidth=3');
  });

  it('writes nothing for values that equal the preset', async () => {
    expect(await encode(withChanges('lamp-noir', {}))).toBe('#v=1&preset=lamp-noir');
  });

  it('prints numbers short and exactly', async () => {
    const hash = await encode(withChanges('lamp', { 'puff.size': 0.1 + 0.2, 'forces.wind.x': 1e-7, seed: 4294967295 }));
    expect(hash).toBe('#v=1&preset=lamp&seed=4294967295&puff.size=0.30000000000000004&forces.wind.x=1e-7');
  });

  it('packs text over 1,500 characters, and only that', async () => {
    const ofVortices = table.filter(({ key, kind }) => kind === 'number' && /^(turbulence|vortices)\b/.test(key));
    const awkward = Object.fromEntries(ofVortices.slice(0, 60).map(({ key }) => [key, 1 / 3]));
    const hash = await encode(withChanges('lamp', { ...awkward, 'light.elevation': 33.333333333333336 }));
    expect(hash).toMatch(/^#v=1&z=[\w-]+$/);
    expect(hash.length).toBeLessThan(1500);
    const { state, notices } = await decode(hash);
    expect(notices).toEqual([]);
    expect(state.values['turbulence.scale']).toBe(1 / 3);
  });
});

it('says that a link cannot contain a model', async () => {
  const { state, notices } = await decode('#v=1&preset=lamp&model=box.glb&models=1');
  expect(state).toEqual(withChanges('lamp', {}));
  expect(notices.map(({ code, message }) => [code, message])).toEqual([
    ['unknownKey', 'A link cannot contain a model.'],
    ['unknownKey', expect.stringContaining('There is no parameter')],
  ]);
});

describe('a timeline in a link', () => {
  const timeline = '120*loop;emission.rate/0*60/60*240*e;style.smokeColor/0*ffffff/60*ff8800*h;burst/30*0*24';

  it('is written as it is, and read without a notice', async () => {
    const state = withChanges('lamp', { timeline });
    const hash = await encode(state);
    expect(hash).toBe(`#v=1&preset=lamp&timeline=${timeline}`);
    expect(await decode(hash)).toEqual({ state, notices: [] });
  });

  it('loses what cannot be used, with a notice for each part', async () => {
    const { state, notices } = await decode('#v=1&timeline=60;seed/0*5;emission.rate/0*-4/9*x/20*7;no.such/0*1');
    expect(state.values.timeline).toBe('60;emission.rate/0*0/20*7');
    expect(new Set(notices.map(({ code, key }) => `${code} ${key}`))).toEqual(new Set(['malformed timeline']));
    expect(notices.map(({ message }) => message)).toEqual([
      expect.stringContaining('timeline.seed'),
      expect.stringContaining('timeline.emission.rate cannot be \u201c-4\u201d'),
      expect.stringContaining('timeline.emission.rate cannot be \u201cx\u201d'),
      expect.stringContaining('There is no parameter no.such'),
    ]);
  });

  it.each(['', 'text', ';;;', '%F0', '\u0000', '{"length":60}', `60;emission.rate/${'0*1/'.repeat(9000)}`])(
    'of %j gives a usable state',
    async (text) => {
      const { state } = await decode(`#v=1&timeline=${encodeURIComponent(text)}`);
      expectUsable(state);
      expect(await decode(await encode(state))).toEqual({ state, notices: [] });
    },
  );
});

describe('a take in a link', () => {
  const take = Uint8Array.from({ length: 3000 }, (_, index) => (index * index) >> 7);

  it('is restored byte for byte after a packed or unpacked state', async () => {
    const rows = table.filter(({ key, kind }) => kind === 'number' && key.startsWith('vortices.')).slice(0, 60);
    const many = withChanges('lamp', Object.fromEntries(rows.map(({ key }) => [key, 1 / 3])));
    for (const state of [withChanges('lamp', { 'puff.size': 2 }), many]) {
      const hash = await encode(state, take);
      expect(hash).toMatch(/&take=[\w-]+$/);
      expect(await decode(hash)).toEqual({ state, take, notices: [] });
    }
  });

  it('is ignored with a notice if it is damaged or too long', async () => {
    const bomb = await packBytes(new Uint8Array(20 * 1024 * 1024));
    for (const packed of ['', '%%%', 'AAAA', (await packBytes(take)).slice(0, 40), bomb]) {
      const { take: read, notices, state } = await decode(`#v=1&puff.size=2&take=${packed}`);
      expect(read).toBeUndefined();
      expect(state.values['puff.size']).toBe(2);
      expect(notices.map(({ code, key }) => [code, key])).toEqual([['damaged', 'take']]);
    }
  });
});

describe('migrations', () => {
  /** Invented: version 2 renames a key, and version 3 changes what a preset looks like. */
  const renamed: Migration = (pairs) => new Map([...pairs].map(([key, text]) => [key === 'old' ? 'new' : key, text]));
  const extended: Migration = (pairs) => new Map([['puff.size', '2'], ...pairs]);
  const migrated = (link: string) =>
    Object.fromEntries(migrate(new Map(new URLSearchParams(link)), [renamed, extended]));

  it.each([
    ['old=1', { v: '3', new: '1', 'puff.size': '2' }],
    ['v=1&old=1', { v: '3', new: '1', 'puff.size': '2' }],
    ['v=2&old=1&puff.size=3', { v: '3', old: '1', 'puff.size': '3' }],
    ['v=3&old=1', { v: '3', old: '1' }],
    ['v=9&old=1', { v: '9', old: '1' }],
    ['v=0&old=1', { v: '0', old: '1' }],
    ['v=1.5&old=1', { v: '1.5', old: '1' }],
    ['v=one&old=1', { v: 'one', old: '1' }],
  ])('apply one after another to links of older versions only: %s', (link, expected) => {
    expect(migrated(link)).toEqual(expected);
  });
});

describe('round trip', () => {
  it('restores random states without a notice', () => expectRoundTrips(1000));
});

describe('decode', () => {
  it('reads an empty hash as the default preset', async () => {
    for (const hash of ['', '#', '#&&']) expect(await decode(hash)).toEqual({ state: defaultState(), notices: [] });
  });

  it('clamps to the limits for links, with a notice', async () => {
    const { state, notices } = await decode('#v=1&simulation.maxParticles=1000000&emission.rate=-5&puff.size=1e999');
    expect(state.values['simulation.maxParticles']).toBe(50_000);
    expect(state.values['emission.rate']).toBe(0);
    expect(state.values['puff.size']).toBe(4);
    expect(notices.map(({ code, key }) => `${code} ${key}`)).toEqual([
      'outOfRange simulation.maxParticles',
      'outOfRange emission.rate',
      'outOfRange puff.size',
    ]);
    expect(notices[0].message).toContain('50000');
  });

  it('falls back to the value of the preset for malformed values', async () => {
    const rate = withChanges('lamp-storm', {}).values['emission.rate'];
    expect(rate).not.toBe(defaultState().values['emission.rate']);
    for (const text of ['NaN', 'Infinity', '0x10', '', '1,5', '--1', '1e', 'abc']) {
      const { state, notices } = await decode(`#preset=lamp-storm&emission.rate=${text}`);
      expect(state.values['emission.rate']).toBe(rate);
      expect(notices.map(({ code }) => code)).toEqual(['malformed']);
    }
    expect(await codes('#style.smokeColor=red')).toEqual(['malformed']);
    expect(await codes('#style.gradient=rainbow')).toEqual(['malformed']);
    expect(await codes('#style.shadows=yes')).toEqual(['malformed']);
    expect(await codes('#scene=nowhere')).toEqual(['malformed']);
    for (const removed of ['sprites', 'shadowMap']) {
      expect(await codes(`#style.renderer=${removed}`), removed).toEqual(['malformed']);
    }
  });

  it('names an unknown preset and shows the default one', async () => {
    const { state, notices } = await decode('#v=1&preset=volcano&emission.rate=9');
    expect(state).toEqual(withChanges(defaultPreset.name, { 'emission.rate': 9 }));
    expect(notices.map(({ code, given }) => [code, given])).toEqual([['unknownPreset', 'volcano']]);
  });

  it('ignores keys of the object prototype, with a notice', async () => {
    for (const key of ['__proto__', 'constructor', 'toString', 'hasOwnProperty', '__proto__.polluted']) {
      const { state, notices } = await decode(`#v=1&${key}=1`);
      expect(notices.map(({ code }) => code)).toEqual(['unknownKey']);
      expect(state).toEqual(defaultState());
    }
    expect(({} as Record<string, unknown>).polluted).toBeUndefined();
    expect(await codes('#preset=__proto__')).toEqual(['unknownPreset']);
  });

  it('reads minus zero as zero', async () => {
    expect((await decode('#forces.wind.x=-0')).state.values['forces.wind.x']).toBe(0);
  });

  it('uses the first of two values, with a notice', async () => {
    const { state, notices } = await decode('#emission.rate=10&emission.rate=20');
    expect(state.values['emission.rate']).toBe(10);
    expect(notices.map(({ code }) => code)).toEqual(['duplicate']);
  });

  it('reads known keys of another version', async () => {
    const { state, notices } = await decode('#v=9&emission.rate=10');
    expect(state.values['emission.rate']).toBe(10);
    expect(notices.map(({ code }) => code)).toEqual(['version']);
  });

  it('reports a damaged packed part', async () => {
    const whole = await pack('v=1&preset=lamp-noir&emission.rate=10');
    for (const packed of ['', '!!!!', 'AAAA', whole.slice(0, 12), `A${whole}`]) {
      expect(await codes(`#v=1&z=${packed}`), packed).toEqual(['damaged']);
    }
  });

  it('reads a pair after a packed part', async () => {
    const { state, notices } = await decode(`#v=1&z=${await pack('v=1&preset=lamp')}&emission.rate=10`);
    expect(state.values['emission.rate']).toBe(10);
    expect(notices).toEqual([]);
  });

  it('stops at 64 KiB, packed or not, and reads no incomplete pair', async () => {
    const filler = 'x'.repeat(DECODED_LIMIT - 40);
    const long = `emission.rate=10&${filler}=1&emission.lifetime=5.25&puff.size=2`;
    for (const hash of [`#${long}`, `#v=1&z=${await pack(long)}`]) {
      const { state, notices } = await decode(hash);
      expect(notices.map(({ code }) => code)).toEqual(['tooLong', 'unknownKey']);
      expect(state.values['emission.rate']).toBe(10);
      expect(state.values['emission.lifetime']).toBe(defaultState().values['emission.lifetime']);
    }
  });

  it('survives a deflate bomb of 50 MB', async () => {
    const bomb = await pack('a'.repeat(50 * 1024 * 1024));
    expect(await codes(`#v=1&z=${bomb}`)).toEqual(['tooLong']);
  });

  it('limits the number and the length of notices', async () => {
    const { notices } = await decode(`#${Array.from({ length: 5000 }, (_, index) => `k${index}=1`).join('&')}`);
    expect(notices).toHaveLength(9);
    expect(notices.at(-1)!.message).toContain('4992');
    const [shown] = (await decode(`#${'y'.repeat(5000)}=1`)).notices;
    expect(shown.message.length).toBeLessThan(120);
  });

  it('gives a valid state for any text', async () => {
    const key = fc.oneof(fc.constantFrom(...table.map((row) => row.key), 'v', 'z', 'preset', '__proto__'), fc.string());
    const text = fc.oneof(
      fc.string(),
      fc.double().map(String),
      fc.constantFrom('<img src=x onerror=alert(1)>', '%', '%zz', '1e308'),
    );
    const link = fc.array(fc.tuple(key, text)).map((pairs) => pairs.map((pair) => pair.join('=')).join('&'));
    await fc.assert(
      fc.asyncProperty(fc.oneof(link, fc.string({ unit: 'binary' })), async (hash) => {
        expectUsable((await decode(`#${hash}`)).state);
      }),
      { numRuns: 1000 },
    );
  });
});

it.each([
  '#?secret=abc123',
  '#secret',
  '##',
  ':~:text=smoke',
  '#:~:text=smoke',
  '?utm_source=mail&utm_medium=link',
  '?fbclid=1#anchor',
])('what a host appends ends the link: %s', async (suffix) => {
  for (const link of ['#v=1&preset=wisp', '#v=1&preset=wisp&emission.rate=40', await packedWisp()]) {
    const decoded = await decode(link);
    expect(await decode(link + suffix), link).toEqual(decoded);
    // As the preset of a call.
    for (const address of ['', 'https://example.org/', 'https://example.org/?t=2'])
      expect(await fetchValues(address + link + suffix), address + link).toEqual(decoded.state.values);
  }
});

it.each(['&utm_source=mail', '&fbclid=1', '&preset=lamp'])(
  'a pair that a host adds loses nothing: %s',
  async (suffix) => {
    const { state } = await decode(`#v=1&preset=wisp&emission.rate=40${suffix}`);
    expect(state).toEqual((await decode('#v=1&preset=wisp&emission.rate=40')).state);
  },
);

async function packedWisp(): Promise<string> {
  return `#v=1&z=${await pack('v=1&preset=wisp&emission.rate=40')}`;
}
