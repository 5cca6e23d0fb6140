import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { crossing, hoopAround } from '../../../examples/ring-game/rules.ts';

const DEPTH = -5;
/** Flies 2 m to the side and 1 m up on the 8 m to the hoops, in 2 s. */
const RING = { from: new Vector3(0, 1, 3), velocity: new Vector3(1, 0.5, -4), start: 10 };
const hoop = (x: number, y: number, radius: number, visible = true) => ({
  radius,
  mesh: { position: new Vector3(x, y, DEPTH), visible },
});

test.each([
  { time: 10, place: undefined },
  { time: 11.99, place: undefined },
  { time: 12, place: [2, 2, DEPTH] },
  // A late frame finds the same place.
  { time: 12.5, place: [2, 2, DEPTH] },
])('a ring crosses the plane of the hoops by second $time: $place', ({ time, place }) => {
  expect(crossing(RING, DEPTH, time)?.toArray()).toEqual(place);
});

test.each([
  { name: 'through its centre', hoops: [hoop(2, 2, 0.5)], hit: 0 },
  { name: 'within its rim', hoops: [hoop(2.3, 2.3, 0.5)], hit: 0 },
  { name: 'beside it', hoops: [hoop(2.4, 2.4, 0.5)], hit: undefined },
  { name: 'where it is invisible', hoops: [hoop(2, 2, 0.5, false)], hit: undefined },
  { name: 'through the second', hoops: [hoop(0, 2, 1), hoop(2, 1.6, 0.5)], hit: 1 },
  { name: 'without hoops', hoops: [], hit: undefined },
])('a ring hits the hoop: $name', ({ hoops, hit }) => {
  const place = crossing(RING, DEPTH, 12)!;
  expect(hoopAround(place, hoops)).toBe(hit === undefined ? undefined : hoops[hit]);
});
