/** The shared fixtures of the browser tests fail when they should. */
import { PNG } from 'pngjs';
import { watchConsoleErrors } from '../support/consoleErrors.ts';
import { expect, test } from '../support/fixtures.ts';
import { bytesOf, compare } from '../support/goldens.ts';

test('draws with SwiftShader', ({ renderer }) => {
  expect(renderer).toContain('SwiftShader');
});

test('imports a source module inside the page', async ({ load }) => {
  const errors = await load<typeof import('../../src/base/errors')>('/src/base/errors.ts');
  expect(await errors.evaluate((module) => new module.LoadError('no file').message)).toBe('no file');
});

test.describe('console errors', () => {
  test.use({ allowed: /on purpose|INVALID_ENUM/ });

  test('are collected from the console, from exceptions and from WebGL', async ({ blank }) => {
    const consoleErrors = watchConsoleErrors(blank);
    await blank.evaluate(() => {
      console.error('said on purpose');
      console.warn('just a warning');
      setTimeout(() => {
        throw new Error('thrown on purpose');
      });
      document.createElement('canvas').getContext('webgl2')?.enable(1);
    });
    await expect.poll(() => consoleErrors.length).toBe(3);
    expect(consoleErrors.join('\n')).toMatch(
      /error: said on purpose[^]*warning: .*INVALID_ENUM[^]*exception: thrown on purpose/,
    );
  });
});

test('a page that logs an error fails its test', async ({ page }) => {
  test.fail();
  await page.evaluate(() => console.error('unexpected'));
});

test.describe('the page shared by the tests of a file', () => {
  test('fails the test that logs an error', async ({ blank }) => {
    test.fail();
    await blank.evaluate(() => console.error('unexpected'));
  });

  test('is reset after a test and loads modules again', async ({ blank, load }) => {
    expect(await blank.evaluate(() => document.body.childElementCount)).toBe(0);
    const errors = await load<typeof import('../../src/base/errors')>('/src/base/errors.ts');
    const sameErrors = await load<typeof import('../../src/base/errors')>('/src/base/errors.ts');
    expect(await errors.evaluate((module, other) => module.LoadError === other.LoadError, sameErrors)).toBe(true);
    await blank.evaluate(() => document.body.append('left behind', document.createElement('p')));
  });

  test('is empty again', async ({ blank }) => {
    expect(await blank.evaluate(() => document.body.childNodes.length)).toBe(0);
  });
});

test('a picture is compared channel by channel', async ({ blank }) => {
  const blob = await blank.evaluateHandle(async () => {
    const canvas = new OffscreenCanvas(4, 2);
    const context = canvas.getContext('2d');
    if (!context) throw new Error('no 2D context');
    context.fillStyle = 'rgb(10 20 30)';
    context.fillRect(0, 0, 4, 2);
    return canvas.convertToBlob();
  });
  const golden = PNG.sync.read(await bytesOf(blob));
  const picture = PNG.sync.read(await bytesOf(blob));
  picture.data[4] += 3;
  picture.data[9] += 9;
  expect(compare(picture, golden, 2)).toMatchObject({ outliers: 2, largest: 9 });
  expect(compare(picture, golden, 3)).toMatchObject({ outliers: 1 });
  expect(compare(picture, golden, 9)).toMatchObject({ outliers: 0 });
  expect(compare(new PNG({ width: 2, height: 4 }), golden, 255).outliers).toBe(8);
});
