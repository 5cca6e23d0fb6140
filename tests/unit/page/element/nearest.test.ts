/** Which boxes of a page the simulator uses if there are too many. */
import { expect, test } from 'vitest';
import { nearest } from '../../../../src/page/element/layout/onPage.ts';

const FRAME = { left: 0, top: 0, width: 600, height: 400 };
/** Twelve boxes in a column, 100 pixels apart; four of them are in the frame. */
const BOXES = Array.from({ length: 12 }, (_, index) => ({ left: 100, top: 10 + 100 * index, width: 200, height: 50 }));

function chosen(count: number, sources: readonly { left: number; top: number; width: number; height: number }[] = []) {
  return nearest(BOXES, count, FRAME, sources).map((box) => BOXES.indexOf(box));
}

test('all elements apply if there is room, in their order', () => {
  expect(chosen(12)).toEqual(BOXES.map((_, index) => index));
  expect(nearest([], 8, FRAME, [])).toEqual([]);
});

test('elements in the picture come first, then the nearest ones', () => {
  const [first, ...others] = BOXES;
  expect(chosen(6)).toEqual([0, 1, 2, 3, 4, 5]);
  expect(nearest([...others.toReversed(), first], 2, FRAME, [])).toEqual([BOXES[3], BOXES[2]]);
});

test('of the elements in the picture, those nearest to an emitter apply, in their order', () => {
  const fire = { left: 150, top: 380, width: 20, height: 10 };
  expect(chosen(2, [fire])).toEqual([2, 3]);
  expect(chosen(2, [fire, { ...fire, top: 0 }])).toEqual([0, 3]);
});

test('an emitter outside the picture selects no element there', () => {
  expect(chosen(4, [{ left: 0, top: 1_000, width: 10, height: 10 }])).toEqual([0, 1, 2, 3]);
});

test('horizontal and vertical distances count equally', () => {
  const [left, right] = [0, 500].map((x) => ({ left: x, top: 200, width: 50, height: 50 }));
  expect(nearest([left, right], 1, FRAME, [{ left: 420, top: 210, width: 10, height: 10 }])).toEqual([right]);
});
