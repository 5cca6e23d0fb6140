import { readdirSync, statSync } from 'node:fs';
import { expect, test } from 'vitest';
import { linkOf, posterOf } from '../../../src/demo/poster.ts';
import { decode } from '../../../src/parameters/codec.ts';
import { VERSION } from '../../../src/parameters/migrations.ts';
import { defaultPreset, findPreset, presets, presetValues } from '../../../src/parameters/presets.ts';

const FOLDER = 'src/demo/posters';

test('each preset has a small poster for wide and for tall windows, and none is unused (npm run thumbnails)', () => {
  const names = presets.flatMap(({ name }) => [`${name}.tall.webp`, `${name}.wide.webp`]).toSorted();
  expect(readdirSync(FOLDER).toSorted()).toEqual(names);
  for (const name of names) expect(statSync(`${FOLDER}/${name}`).size, name).toBeLessThan(30_000);
});

test('a link shows the poster of its preset', () => {
  expect(posterOf('', `#v=${VERSION}&seed=3`)).toBe(defaultPreset.name);
  expect(posterOf('?t=2&paused=1', '#v=1&preset=wisp-matcha')).toBe('wisp-matcha');
  expect(posterOf('', '#v=1&preset=train&seed=4&emission.rate=40&simulation.maxParticles=500')).toBe('train');
});

test('what a host appends does not change the poster', () => {
  for (const suffix of ['#?secret=1', '?utm_source=mail', ':~:text=smoke'])
    expect(posterOf('', `#v=1&preset=wisp${suffix}`), suffix).toBe('wisp');
  expect(posterOf('', '#?secret=1')).toBe(posterOf('', ''));
});

test('an address without a link shows the first look, which is a preset', async () => {
  for (const hash of ['', '#']) {
    const { state, notices } = await decode(linkOf(hash));
    expect(notices).toEqual([]);
    expect(state.values).toEqual(presetValues(findPreset(state.preset)!));
    expect(posterOf('?t=2', hash)).toBe(state.preset);
  }
  expect(linkOf('#seed=3')).toBe('#seed=3');
});

test('a link of another version, or without one, has no poster', () => {
  for (const link of ['#v=9&preset=lamp', '#v=0&preset=lamp', '#preset=lamp'])
    expect(posterOf('', link), link).toBeUndefined();
});

test('a link that may look different has no poster', () => {
  for (const change of ['style.ink=0', 'light.azimuth=3', 'camera.distance=2', 'puff.form=billboards', 'scene=wisp'])
    expect(posterOf('', `#v=1&preset=lamp&${change}`), change).toBeUndefined();
  expect(posterOf('', '#v=1&z=abc')).toBeUndefined();
  expect(posterOf('?view=depth', '#v=1&preset=lamp')).toBeUndefined();
});
