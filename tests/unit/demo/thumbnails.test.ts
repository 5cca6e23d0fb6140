import { readdirSync, statSync } from 'node:fs';
import { expect, test } from 'vitest';
import { presets } from '../../../src/parameters/presets.ts';

const FOLDER = 'public/thumbnails';

test('each preset has a small thumbnail, and none is unused (npm run thumbnails)', () => {
  const names = presets.map(({ name }) => `${name}.webp`).toSorted();
  expect(readdirSync(FOLDER).toSorted()).toEqual(names);
  for (const name of names) expect(statSync(`${FOLDER}/${name}`).size, name).toBeLessThan(10_000);
});
