import { expect, test } from '../../support/fixtures.ts';
import type { PlacedSmoke } from './handles.cases.ts';

type Handles = typeof import('./handles.cases.ts');
const HANDLES = '/tests/visual/three/handles.cases.ts';

/** Puffs of radius 0.2 m with centres within 0.15 m, at about 4.5 m: 0.35 m are up to 15 px, with lumps and ink. */
function expectSmoke({ pixels, off, reach }: PlacedSmoke, what: string): void {
  expect(pixels, what).toBeGreaterThan(250);
  expect(off, what).toBeLessThan(2);
  expect(reach, what).toBeLessThan(20);
}

test('a burst draws smoke at its place, and is gone after its lifetime', async ({ load }) => {
  const cases = await load<Handles>(HANDLES);
  const [before, during, after] = await cases.evaluate((module) => module.burst());
  expect([before.pixels, after.pixels]).toEqual([0, 0]);
  expectSmoke(during, 'the burst');
});

test('an emitter draws smoke at its object, pauses with it, and ends by remove', async ({ load }) => {
  const cases = await load<Handles>(HANDLES);
  const seen = await cases.evaluate((module) => module.emitter());
  const states = ['first', 'moved', 'disabled', 'enabled', 'out of the scene', 'back', 'removed'];
  expect(seen).toHaveLength(states.length);
  seen.forEach((spot, index) => {
    if ([2, 4, 6].includes(index)) expect(spot.pixels, states[index]).toBe(0);
    else expectSmoke(spot, states[index]);
  });
});

test('a caster throws its shadow until it is disabled or removed', async ({ load }) => {
  const cases = await load<Handles>(HANDLES);
  const [casting, disabled, again, removed] = await cases.evaluate((module) => module.caster());
  expect(casting).toBeGreaterThan(200);
  expect([disabled, again, removed]).toEqual([0, casting, 0]);
});

test('a thousand adds and removes of each handle leave no objects on the GPU', async ({ load }) => {
  const cases = await load<Handles>(HANDLES);
  const [early, late] = await cases.evaluate((module) => module.census(1000));
  expect(late).toEqual(early);
});

test('smoke without particles and casters makes no draw call after the first frame', async ({ load }) => {
  const cases = await load<Handles>(HANDLES);
  const { first, empty, burst, after, casting, removed } = await cases.evaluate((module) => module.idle());
  // The first frame compiles the programs.
  expect(first.calls).toBeGreaterThan(0);
  for (const idle of [empty, after, removed]) expect(idle).toEqual({ calls: 0, changed: 0, bodies: 0 });
  for (const drawn of [burst, casting]) {
    expect(drawn.calls).toBeGreaterThan(0);
    expect(drawn.changed).toBeGreaterThan(100);
  }
  expect([burst.bodies > 0, casting.bodies]).toEqual([true, 0]);
});

test('the same calls give the same hash', async ({ load }) => {
  const cases = await load<Handles>(HANDLES);
  const [first, second, without] = await cases.evaluate((module) => module.hashes());
  expect(second).toBe(first);
  expect(without).not.toBe(first);
});

test('mistakes in a frame are one error event each, and everything goes on after them', async ({ load }) => {
  const cases = await load<Handles>(HANDLES);
  const { said, alive, pixels } = await cases.evaluate((module) => module.mistakes());
  expect(said).toEqual([
    expect.stringMatching(/^ParameterError: emitFrom\.object cannot be “Mesh at NaN/),
    expect.stringMatching(/^ParameterError: collide\.object cannot be “Mesh at NaN/),
    expect.stringMatching(/^ParameterError: cast\.object cannot be “Mesh at NaN/),
    expect.stringMatching(/^ParameterError: seconds cannot be NaN/),
  ]);
  expect(alive).toBeGreaterThan(30);
  expect(pixels).toBeGreaterThan(250);
});
