import { expect, test } from '../../../support/fixtures.ts';

type Colliders = typeof import('./colliders.cases.ts');
const COLLIDERS = '/tests/visual/three/state/colliders.cases.ts';
const MESHES = '**/meshes/bindings_bg.wasm*';

const isPhysics = (url: string) => url.includes('physics/bindings_bg.wasm');

test.use({ ownPage: true, allowed: /Failed to load resource/ });

test('smoke collides with balls, boxes, capsules and planes without more being loaded', async ({ blank, load }) => {
  const asked: string[] = [];
  blank.on('request', (request) => asked.push(request.url()));
  const cases = await load<Colliders>(COLLIDERS);
  const { heights, said } = await cases.evaluate((module) => module.simple());
  const [free, ...stopped] = heights;
  expect(free).toBeGreaterThan(3);
  for (const height of stopped) expect(height).toBeLessThan(1.2);
  expect(said).toEqual([]);
  expect(asked.filter((url) => url.includes('core/bindings_bg.wasm')).length).toBeGreaterThan(0);
  expect(asked.filter((url) => isPhysics(url) || url.includes('meshes/bindings_bg.wasm'))).toEqual([]);
});

test('a mesh loads no physics but meshes, with progress, again after a failure, and collides from then on', async ({
  blank,
  load,
}) => {
  let requests = 0;
  const asked: string[] = [];
  blank.on('request', (request) => asked.push(request.url()));
  await blank.route(MESHES, (route) => (requests++ === 0 ? route.abort() : route.continue()));
  const cases = await load<Colliders>(COLLIDERS);
  const { said, heights, rigids, steps } = await cases.evaluate((module) => module.needy());
  expect(requests).toBe(2);
  expect(said[0]).toBe('LoadError');
  expect(said.length).toBeGreaterThan(1);
  expect(new Set(said.slice(1))).toEqual(new Set(['progress']));
  expect(rigids).toEqual([0, 2]);
  expect(heights[0]).toBeGreaterThan(3);
  expect(heights[1]).toBeLessThan(1.3);
  expect(steps).toBe(8 + 360);
  expect(asked.filter(isPhysics)).toEqual([]);
});

test('an object that smoke pushes loads physics, also while and after meshes are loaded', async ({ blank, load }) => {
  const asked: string[] = [];
  blank.on('request', (request) => asked.push(request.url()));
  const cases = await load<Colliders>(COLLIDERS);
  const { early, late, heights, said } = await cases.evaluate((module) => module.both());
  expect([early, late]).toEqual([2, 3]);
  for (const height of heights) expect(height).toBeLessThan(-1);
  expect(said).toEqual(['progress']);
  expect(asked.filter(isPhysics).length).toBeGreaterThan(0);
});
