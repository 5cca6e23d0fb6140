/** `version1.json` and `version2.json` have the values of the presets in links of that version that differ from the defaults. */
import { readFileSync } from 'node:fs';
import { expect, it, vi } from 'vitest';
import { decode, encode } from '../../../src/preset/codec.ts';
import { readFile } from '../../../src/preset/file.ts';
import type { Values } from '../../../src/preset/parameter.ts';
import { findPreset, presets, presetValues } from '../../../src/preset/presets.ts';
import { findParameter } from '../../../src/preset/table.ts';
import { defaults } from '../../../src/preset/values.ts';
import { sceneNamed } from '../../../src/scenes/scenes.ts';

const [version1, version2] = [1, 2].map(
  (version) =>
    JSON.parse(readFileSync(new URL(`version${version}.json`, import.meta.url), 'utf8')) as Record<string, Values>,
);
const recorded: [version: number, name: string, own: Values][] = [
  ...Object.entries(version1).map(([name, own]): [number, string, Values] => [1, name, own]),
  ...Object.entries(version2).map(([name, own]): [number, string, Values] => [2, name, own]),
];

/** All values of a preset of an older version. A list item that only the current preset changes had the scene's value. */
async function valuesThen(name: string, own: Values): Promise<Values> {
  const { values } = presets.find((preset) => preset.name === name)!;
  const { rig } = await sceneNamed(values.scene ?? 'lamp').load();
  const ofScene = Object.keys(values).filter((key) => findParameter(key)!.isOptional && key in rig);
  return { ...defaults(), ...Object.fromEntries(ofScene.map((key) => [key, rig[key]])), ...own };
}

it('has the 24 presets of version 1 and the 30 of version 2', () => {
  expect([version1, version2].map((presetsThen) => Object.keys(presetsThen).length)).toEqual([24, 30]);
});

it.each(recorded)('version %i of %s is that of its links and files', async (version, name, own) => {
  const values = await valuesThen(name, own);
  for (const start of version === 1 ? ['v=1&', 'v=0&', ''] : ['v=2&']) {
    expect(await decode(`#${start}preset=${name}`), start).toEqual({ state: { preset: name, values }, notices: [] });
  }
  const file = await readFile(`{"format": "cartoon-smoke", "version": ${version}, "preset": "${name}", "values": {}}`);
  expect(file.state).toEqual({ preset: name, values });
});

it.each(recorded)('version %i of %s has the same values in the link that is written of it', async (version, name) => {
  const { state } = await decode(`#v=${version}&preset=${name}&emission.lifetime=3.5`);
  const written = await encode(state);
  expect(written).toMatch(/^#v=3&/);
  expect((await decode(written)).state).toEqual(state);
});

it.each(presets)('$name has its current values in links of version 3, and a notice in later ones', async (preset) => {
  const state = { preset: preset.name, values: presetValues(preset) };
  expect(await decode(`#v=3&preset=${preset.name}`)).toEqual({ state, notices: [] });
  const later = await decode(`#v=4&preset=${preset.name}`);
  expect({ state: later.state, codes: later.notices.map(({ code }) => code) }).toEqual({ state, codes: ['version'] });
});

it('is the base of malformed values and of unknown presets', async () => {
  const { state } = await decode('#v=1&preset=volcano&style.simplify=much');
  expect(state).toEqual({ preset: 'lamp', values: await valuesThen('lamp', version1.lamp) });
});

it('gives presets that version 1 does not have their first values', async () => {
  const newer = presets.filter(({ name }) => !(name in version1));
  expect(newer.length).toBeGreaterThan(5);
  for (const { name, values } of newer) {
    const { state } = await decode(`#v=1&preset=${name}`);
    expect(state).toEqual({ preset: name, values: await valuesThen(name, version2[name] ?? values) });
  }
});

it('is not the meaning of an empty link', async () => {
  const { state } = await decode('');
  expect(state).toEqual({ preset: 'lamp', values: presetValues(findPreset('lamp')!) });
});

it('is replaced by the current values, with a notice, if it cannot be loaded', async () => {
  vi.resetModules();
  vi.doMock('../../../src/preset/olderValues.ts', () => Promise.reject(new Error('offline')));
  const { decode: decodeOffline } = await import('../../../src/preset/codec.ts');
  const { state, notices } = await decodeOffline('#v=1&preset=lamp');
  vi.doUnmock('../../../src/preset/olderValues.ts');
  expect(state).toEqual({ preset: 'lamp', values: presetValues(findPreset('lamp')!) });
  expect(notices.map(({ code, message }) => [code, message])).toEqual([
    ['version', 'The look of this older link could not be loaded; the current one is shown.'],
  ]);
});

it.each([
  ['1', version1],
  ['2', version2],
])('version %s differs from the current values of most presets', (_, presetsThen) => {
  const changed = Object.entries(presetsThen).filter(([name, own]) => {
    const [before, now] = [own, findPreset(name)!.values].map((values) => ({ ...defaults(), ...values }));
    return JSON.stringify(before) !== JSON.stringify(now);
  });
  expect(changed.length).toBeGreaterThan(20);
});
