/** Models of GLB files: their surfaces, outlines and shadows, and files that cannot be used. */
import { expect, longIf, test } from '../../support/fixtures.ts';
import { bytesOf, expectGolden } from '../../support/goldens.ts';

type Cases = typeof import('./model.cases.ts');
const CASES = '/tests/visual/stage/model.cases.ts';

test.describe('draws', () => {
  for (const [name, least] of [
    ['turningBox', { model: 2000, shadow: 300, ink: 200 }],
    ['bendingColumn', { model: 1000, shadow: 60, ink: 100 }],
    ['sheet', { model: 800, shadow: 100, ink: 60 }],
    ['fan', { model: 800, shadow: 100, ink: 60 }],
  ] as const) {
    test(`surfaces, shadows and outlines: ${name}${longIf(name !== 'turningBox')}`, async ({ load, renderer }) => {
      expect(renderer).toContain('SwiftShader');
      const cases = await load<Cases>(CASES);
      const found = await cases.evaluate((module, file) => module.changes(file), name);
      expect(found.model).toBeGreaterThan(least.model);
      expect(found.shadow).toBeGreaterThan(least.shadow);
      expect(found.ink).toBeGreaterThan(least.ink);
      // Both sides of a sheet are drawn.
      if (name === 'sheet') for (const red of found.red) expect(red).toBeGreaterThan(400);
    });
  }

  test('the colour of the texture where the triangles are', async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const [red, green, blue] = await cases.evaluate((module) => module.textureColor());
    expect(Math.abs(red - 0xd0)).toBeLessThan(4);
    expect(Math.abs(green - 0x20)).toBeLessThan(4);
    expect(Math.abs(blue - 0x10)).toBeLessThan(4);
  });

  test('the same after a lost context', async ({ load }) => {
    expect(await (await load<Cases>(CASES)).evaluate((module) => module.lostContext())).toBe(0);
  });
});

test('a house with smoke from its chimney is the picture of docs/models.md @long', async ({ load }, testInfo) => {
  const cases = await load<Cases>(CASES);
  const picture = await bytesOf(await cases.evaluateHandle((module) => module.housePicture()));
  expect(picture.length).toBeLessThan(75_000);
  await expectGolden(picture, { name: '../../../docs/images/model', tolerance: 8, outliers: 40 }, testInfo);
});

test('a model stays in copies and other scenes until it is removed @long', async ({ load }) => {
  const found = await (await load<Cases>(CASES)).evaluate((module) => module.life());
  expect(found.names.slice(-3)).toEqual(['model', 'Top', 'Base']);
  expect(found.played?.animations).toEqual([{ name: 'Turn', seconds: 4 }]);
  expect(found.sought).toBe(found.hash);
  expect(found.copied).toEqual({ hash: found.hash, differing: 0 });
  expect(found.picked?.node.name).toBe('Base');
  expect(Math.hypot(...found.picked!.direction)).toBeCloseTo(1, 5);
  expect(found.missed).toBeNull();
  expect(found.elsewhere).toBe(22);
  expect(found.removed).toBeNull();
});

test('a file that cannot be used changes nothing', async ({ load }) => {
  const files = [[], [1, 2, 3], [...Buffer.from('glTF')], [...Buffer.alloc(4000, 7)]];
  const cases = await load<Cases>(CASES);
  const { errors, differing, steps } = await cases.evaluate((module, all) => module.refused(all), files);
  expect(errors.length).toBe(files.length + 1);
  for (const error of errors.slice(0, -1)) expect(error).toMatch(/^FileError: .*not a GLB file/);
  expect(errors.at(-1)).toBe('ParameterError: setModel.size cannot be -1: it takes a number from 0.01 to 100.');
  expect([differing, steps]).toEqual([0, 20]);
});

test('addresses in a file are not fetched', async ({ load, page }) => {
  const cases = await load<Cases>(CASES);
  const requests: string[] = [];
  page.on('request', (request) => requests.push(request.url()));
  const notices = await cases.evaluate((module) => module.noticesOf(module.referring()));
  expect(notices.join(' ')).toMatch(/example\.org\/secret\.png is in another file.*other\.png is in another file/);
  expect(requests.filter((url) => /secret|other\.png/.test(url))).toEqual([]);
});
