import { beforeAll, expect, test } from 'vitest';
import { bakeLobes } from '../../../../src/renderer/puffs/bake/bakeLobes.ts';
import { bakingCaps } from '../../../../src/renderer/puffs/bake/lobeCaps.ts';
import { FIRST_BORDER } from '../../../../src/renderer/gpu/ramps.ts';
import { LruCache } from '../../../../src/renderer/puffs/lru.ts';
import { DEFAULT_DESIGN, designedShapes } from '../../../../src/renderer/puffs/lobeShapes.ts';
import { bakingPuffs } from '../../../../src/renderer/bakedPuffs.ts';
import { fetchExtras } from '../../../../src/renderer/extraPasses.ts';
import { styleOf } from '../../../../src/renderer/style.ts';
import { defaults } from '../../../../src/parameters/values.ts';
import { finished, inPieces, nextTask, workedFor, type Work } from '../../../../src/base/work.ts';

beforeAll(() => fetchExtras(styleOf(defaults())));

function* counted(pieces: number, done: number[]): Work<string> {
  for (let piece = 0; piece < pieces; piece++) {
    done.push(piece);
    yield;
  }
  return 'ready';
}

test('work continues where it stopped, and at least one piece is done', () => {
  const done: number[] = [];
  const work = counted(2, done);
  expect(workedFor(work, 0)).toBeUndefined();
  expect(done).toEqual([0]);
  expect(finished(work)).toBe('ready');
  expect(done).toEqual([0, 1]);
});

test('other tasks run between pieces', async () => {
  const done: number[] = [];
  const counts: number[] = [];
  const taking = (async () => {
    while (done.length < 4) {
      counts.push(done.length);
      await nextTask();
    }
  })();
  expect(await inPieces(counted(4, done), 0)).toBe('ready');
  await taking;
  for (const pieces of [1, 2, 3]) expect(counts).toContain(pieces);
});

test('puffs baked in pieces equal those baked at once', () => {
  const shapes = designedShapes({ ...DEFAULT_DESIGN, seed: 5 }, 2);
  const work = bakingPuffs(shapes, { caps: true });
  let baked;
  let pieces = 0;
  while (!(baked = workedFor(work, 0))) pieces++;
  expect(pieces).toBeGreaterThan(60);
  const { caps, ...lobes } = baked.lobes;
  expect(lobes).toEqual(bakeLobes(shapes));
  expect(caps).toEqual(finished(bakingCaps(shapes, FIRST_BORDER)));
});

test('a second request joins a bake in progress', () => {
  const works = [1, 2].map(() => bakingPuffs(designedShapes({ ...DEFAULT_DESIGN, seed: 8 }, 1), { caps: true }));
  const alone = bakingPuffs(designedShapes({ ...DEFAULT_DESIGN, seed: 59 }, 1), { caps: true });
  let pieces = 0;
  while (!workedFor(alone, 0)) pieces++;
  const baked: unknown[] = [undefined, undefined];
  let rounds = 0;
  for (; baked.includes(undefined) && rounds < pieces; rounds++) {
    works.forEach((work, index) => (baked[index] ??= workedFor(work, 0)));
  }
  // Two workers need half as many rounds as one.
  expect(rounds).toBeLessThan(0.6 * pieces);
  expect(baked[0]).toBeDefined();
  expect(baked[0]).toBe(baked[1]);
});

test('one more variation bakes only that one', () => {
  const pieces = (count: number): number => {
    const work = bakingPuffs(designedShapes({ ...DEFAULT_DESIGN, seed: 6 }, count), { caps: true });
    let number = 0;
    while (!workedFor(work, 0)) number++;
    return number;
  };
  const one = pieces(1);
  expect(one).toBeGreaterThan(30);
  expect(pieces(2)).toBe(one);
  expect(pieces(2)).toBe(0);
});

test('the least recently used entry is evicted first', () => {
  const cache = new LruCache<number>(2);
  cache.add('a', 1);
  cache.add('b', 2);
  expect(cache.get('a')).toBe(1);
  cache.add('c', 3);
  expect([cache.get('a'), cache.get('b'), cache.get('c')]).toEqual([1, undefined, 3]);
});
