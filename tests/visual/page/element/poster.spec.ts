import { PNG } from 'pngjs';
import { expect, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./poster.cases.ts');

const LINK = 'https://example.org/?t=1.5#v=1&preset=wisp&simulation.maxParticles=300';
const [WIDTH, HEIGHT] = [160, 120];

test('a poster equals the first frame of an element with the same link', async ({ load, blank }) => {
  const cases = await load<Cases>('/tests/visual/page/element/poster.cases.ts');
  const order = { link: LINK, width: WIDTH, height: HEIGHT, isTransparent: false };
  const { png, notices } = await cases.evaluate((module, given) => module.poster(given), order);
  expect(notices).toEqual([]);
  await cases.evaluate((module, [link, width, height]) => module.showFirst(link, width, height), [
    LINK,
    WIDTH,
    HEIGHT,
  ] as const);
  const [drawn, shown] = [Buffer.from(png, 'base64'), await blank.locator('cartoon-smoke').screenshot()].map((file) =>
    PNG.sync.read(file),
  );
  expect([drawn.width, drawn.height]).toEqual([WIDTH, HEIGHT]);
  expect(drawn.data.equals(shown.data)).toBe(true);
  const colors = new Set(new Uint32Array(Uint8Array.from(drawn.data).buffer));
  expect(colors.size, 'colours of the smoke').toBeGreaterThan(20);
});

test('invalid parts of a link are reported', async ({ load }) => {
  const cases = await load<Cases>('/tests/visual/page/element/poster.cases.ts');
  const order = { link: '#v=1&preset=fog&scene=wisp', width: 16, height: 16, isTransparent: true };
  const { notices } = await cases.evaluate((module, given) => module.poster(given), order);
  expect(notices.join()).toContain('no preset');
});
