/** Every preset ends in the state of the committed list, which Node generates. */
import { readFileSync } from 'node:fs';
import { describe, expect } from 'vitest';
import { presets } from '../../src/parameters/presets.ts';
import { linesOf } from '../support/sim/hashFixture.ts';
import { MODEL_HASHES } from '../support/sim/modelHashes.ts';
import { loadVariant } from '../support/sim/simWasm.ts';
import { TIMELINE_HASH, timelineHashes, timelineValues } from '../support/sim/timelineHashes.ts';
import { engine, test } from './fixtures.ts';
import hashes from './hashes.json' with { type: 'json' };

type Page = typeof import('./page/hashes.ts');

const wanted: Record<string, Record<string, string>> = hashes;

test('the list has every preset, at 2, 8 and 20 s', () => {
  expect(Object.keys(wanted).sort()).toEqual(presets.map(({ name }) => name).sort());
  for (const moments of Object.values(wanted)) expect(Object.keys(moments)).toEqual(['2', '8', '20']);
});

describe('hashes', () => {
  test.for(Object.keys(wanted))('%s', async (name, { load, task }) => {
    const page = await load<Page>('/tests/engines/page/hashes.ts');
    const found = await page.hashesInPage(name, Object.keys(wanted[name]).map(Number));
    task.meta.note = `hashes  ${name}  ${engine.title}  ${Object.values(found).join('  ')}`;
    expect(found).toEqual(wanted[name]);
  });
});

test('meshes without Rapier end in the native state', async ({ load }) => {
  const fixture = readFileSync(new URL('../../sim-wasm/sim/tests/collide_fixture.txt', import.meta.url), 'utf8');
  const page = await load<Page>('/tests/engines/page/hashes.ts');
  expect(await page.hashOfMeshes(fixture)).toBe(linesOf(fixture, 'hash with meshes')[0]);
});

test('models of GLB files that collide and carry emitters end in the state of Node', async ({ load }) => {
  const page = await load<Page>('/tests/engines/page/hashes.ts');
  expect(await page.modelsInPage()).toEqual(MODEL_HASHES);
});

test('a timeline with each kind of parameter ends in the state of Node, played, sought and replayed', async ({
  load,
}) => {
  const page = await load<Page>('/tests/engines/page/hashes.ts');
  const { hashes: found, values } = await page.timelineInPage();
  expect(new Set(Object.values(found))).toEqual(new Set([TIMELINE_HASH]));
  expect(values).toBe(timelineValues());
  expect(await timelineHashes(await loadVariant('core'))).toEqual(found);
});
