import { expect, it } from 'vitest';
import { BOX_NUMBERS, BoxTree, isNear } from '../../../../src/passes/edges/boxTree.ts';
import { random } from '../../../visual/random.ts';

it('finds the boxes that a search of all boxes finds, in the same order', () => {
  const next = random(7);
  const boxOf = (size: number) => {
    const low = [next(), next(), next()];
    return [...low, ...low.map((value) => value + size * next())];
  };
  const boxes = (count: number, size: number) =>
    Float32Array.from(Array.from({ length: count }, () => boxOf(size)).flat());
  const [tree, others] = [boxes(300, 0.3), boxes(50, 0.5)];
  const all = Array.from({ length: 300 }, (_, number) => number);
  let found = 0;
  for (let at = 0; at < others.length; at += BOX_NUMBERS) {
    const near = all.filter((number) => isNear(tree, BOX_NUMBERS * number, others, at));
    found += near.length;
    expect(new BoxTree(tree).near(others, at)).toEqual(near);
  }
  expect(found).toBeGreaterThan(100);
});
