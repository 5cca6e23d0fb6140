import { readdirSync, statSync } from 'node:fs';
import { expect, test } from 'vitest';
import { posterOf } from '../../../src/app/poster.ts';
import { defaultPreset, presets } from '../../../src/preset/presets.ts';

const FOLDER = 'src/app/posters';

test('each preset has a small poster for wide and for tall windows, and none is unused (npm run thumbnails)', () => {
  const names = presets.flatMap(({ name }) => [`${name}.tall.webp`, `${name}.wide.webp`]).toSorted();
  expect(readdirSync(FOLDER).toSorted()).toEqual(names);
  for (const name of names) expect(statSync(`${FOLDER}/${name}`).size, name).toBeLessThan(30_000);
});

test('a link shows the poster of its preset', () => {
  expect(posterOf('', '')).toBe(defaultPreset.name);
  expect(posterOf('?t=2&paused=1', '#v=1&preset=wisp-matcha')).toBe('wisp-matcha');
  expect(posterOf('', '#v=1&preset=train&seed=4&emission.rate=40&simulation.maxParticles=500')).toBe('train');
});

test('a link that may look different has no poster', () => {
  for (const change of ['style.ink=0', 'light.azimuth=3', 'camera.distance=2', 'puff.form=billboards', 'scene=wisp'])
    expect(posterOf('', `#v=1&preset=lamp&${change}`), change).toBeUndefined();
  expect(posterOf('', '#v=1&z=abc')).toBeUndefined();
  expect(posterOf('?view=depth', '#v=1&preset=lamp')).toBeUndefined();
});
