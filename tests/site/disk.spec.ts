/** The built pages where they cannot run: opened from the disk, or in an older browser. */
import { fileURLToPath, pathToFileURL } from 'node:url';
import { expect, test } from '../support/fixtures.ts';

const DIST = fileURLToPath(new URL('../../dist', import.meta.url));
const SIZES = [
  { width: 1440, height: 900 },
  { width: 390, height: 844 },
];

// The browser refuses the files of the page.
test.use({ allowed: /./, serviceWorkers: 'block', deviceScaleFactor: 1 });

for (const name of ['index', 'paper', 'puff', 'examples']) {
  test(`${name}.html opened from the disk says only how to serve it`, async ({ page }, testInfo) => {
    for (const size of SIZES) {
      await page.setViewportSize(size);
      await page.goto(`${pathToFileURL(DIST).href}/${name}.html`);
      const message = page.getByRole('alert');
      await expect(message).toContainText('Serve the folder with a web server');
      expect(await page.evaluate(() => document.body.innerText.trim())).toBe(await message.innerText());
      const { x, y, width, height } = (await message.boundingBox())!;
      expect(Math.min(x, y, size.width - x - width, size.height - y - height)).toBeGreaterThanOrEqual(0);
      await page.screenshot({ path: testInfo.outputPath(`${name}-${size.width}.png`) });
    }
  });
}

test('embed.html, whose code is in classic scripts, draws smoke from the disk', async ({ page }) => {
  await page.goto(`${pathToFileURL(DIST).href}/embed.html#preset=wisp&simulation.maxParticles=300`);
  await page.waitForFunction(() => document.querySelector('cartoon-smoke')?.ready?.then(() => true));
});

for (const api of ['WebGL2RenderingContext', 'DecompressionStream', 'WebAssembly']) {
  test(`without ${api} the demo page names the browsers that it needs`, async ({ page, server }) => {
    await page.addInitScript((name) => void Reflect.deleteProperty(window, name), api);
    await page.goto(`${server.address}dist/index.html`);
    await expect(page.getByRole('alert')).toContainText('needs a newer browser: Chrome or Edge 111');
  });
}
