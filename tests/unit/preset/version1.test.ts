/** `version1.json` has the values of the presets in links of version 1, where they differ from the defaults. */
import { readFileSync } from 'node:fs';
import { expect, it, vi } from 'vitest';
import { decode, encode } from '../../../src/preset/codec.ts';
import { readFile } from '../../../src/preset/file.ts';
import type { Values } from '../../../src/preset/parameter.ts';
import { findPreset, presets, presetValues } from '../../../src/preset/presets.ts';
import { defaults } from '../../../src/preset/values.ts';

const recorded = JSON.parse(readFileSync(new URL('version1.json', import.meta.url), 'utf8')) as Record<string, Values>;
const names = Object.keys(recorded);

it('has the 24 presets of version 1', () => {
  expect(names.length).toBe(24);
});

it.each(names)(
  '%s has its old values in links of version 1, of version 0 and without one, and in files',
  async (name) => {
    const values = { ...defaults(), ...recorded[name] };
    for (const start of ['v=1&', 'v=0&', '']) {
      expect(await decode(`#${start}preset=${name}`), start).toEqual({ state: { preset: name, values }, notices: [] });
    }
    const file = await readFile(`{"format": "cartoon-smoke", "version": 1, "preset": "${name}", "values": {}}`);
    expect(file.state).toEqual({ preset: name, values });
  },
);

it.each(names)('%s has its current values in links of version 2, and a notice in later ones', async (name) => {
  const state = { preset: name, values: presetValues(findPreset(name)!) };
  expect(await decode(`#v=2&preset=${name}`)).toEqual({ state, notices: [] });
  const later = await decode(`#v=3&preset=${name}`);
  expect({ state: later.state, codes: later.notices.map(({ code }) => code) }).toEqual({ state, codes: ['version'] });
});

it.each(names)('%s of version 1 has the same values in the link that is written of it', async (name) => {
  const { state } = await decode(`#v=1&preset=${name}&emission.lifetime=3.5`);
  const written = await encode(state);
  expect(written).toMatch(/^#v=2&/);
  expect((await decode(written)).state).toEqual(state);
});

it('is the base of malformed values and of unknown presets', async () => {
  const { state } = await decode('#v=1&preset=volcano&style.simplify=much');
  expect(state).toEqual({ preset: 'lamp', values: { ...defaults(), ...recorded.lamp } });
});

it('has no newer presets, which keep their values', async () => {
  const newer = presets.filter(({ name }) => !names.includes(name));
  expect(newer.length).toBeGreaterThan(5);
  for (const { name, values } of newer) {
    const { state } = await decode(`#v=1&preset=${name}`);
    expect(state).toEqual({ preset: name, values: { ...defaults(), ...values } });
  }
});

it('is not the meaning of an empty link', async () => {
  const { state } = await decode('');
  expect(state).toEqual({ preset: 'lamp', values: presetValues(findPreset('lamp')!) });
});

it('is replaced by the current values, with a notice, if it cannot be loaded', async () => {
  vi.resetModules();
  vi.doMock('../../../src/preset/version1.ts', () => Promise.reject(new Error('offline')));
  const { decode: decodeOffline } = await import('../../../src/preset/codec.ts');
  const { state, notices } = await decodeOffline('#v=1&preset=lamp');
  vi.doUnmock('../../../src/preset/version1.ts');
  expect(state).toEqual({ preset: 'lamp', values: presetValues(findPreset('lamp')!) });
  expect(notices.map(({ code, message }) => [code, message])).toEqual([
    ['version', 'The look of this older link could not be loaded; the current one is shown.'],
  ]);
});

it('differs from the current values of most presets', () => {
  const changed = names.filter((name) => {
    const [before, now] = [recorded[name], findPreset(name)!.values].map((values) => ({ ...defaults(), ...values }));
    return JSON.stringify(before) !== JSON.stringify(now);
  });
  expect(changed.length).toBeGreaterThan(20);
});
