/**
 * Downloads of `<cartoon-smoke preset="wisp">`, in kilobytes on the wire (gzip -9). Where a limit is that of the plain
 * drawing, `style-simplify="0"` and `style-form="0"` leave out the pass that the preset adds.
 */
import { expect, stands, test, type Server } from '../../../support/embed.ts';

interface Figure {
  readonly name: string;
  readonly kB: number;
  readonly limit: number;
}

function fetched(server: Server, isCounted: (file: string) => boolean): number {
  const files = new Map(server.sent.map(({ file, bytes }) => [file, bytes]));
  return [...files].reduce((sum, [file, bytes]) => sum + (isCounted(file) ? bytes : 0), 0) / 1000;
}

const isScript = (file: string) => file.endsWith('.js');
const isThree = (file: string) => file.includes('node_modules/three');

/** Files that a wisp on a page's main thread never needs. */
const RARITIES =
  'lamp train physics meshes worker preset.js presets.js Looks rigidArguments softNormal selle debugViews billboards countedVolumes strokes simplify link moment pointers onPage animation timeline portStage';

function judge(figures: readonly Figure[]): void {
  for (const { name, kB, limit } of figures) {
    const said = `${name}: ${kB.toFixed(1)} kB, limit ${limit}`;
    process.stdout.write(`${said}\n`);
    expect(kB, said).toBeLessThan(limit);
  }
}

test('on the main thread, beside the three.js of the page', async ({ page, openPage, server }) => {
  await openPage(
    '<cartoon-smoke preset="wisp" style-simplify="0" style-form="0" thread="main" paused></cartoon-smoke>',
  );
  await stands(page);
  const core = fetched(server, (file) => isScript(file) && !isThree(file));
  judge([
    { name: 'embed.coreKb', kB: core, limit: 88.8 },
    { name: 'simulator', kB: fetched(server, (file) => file.endsWith('.wasm')), limit: 130 },
  ]);
  const names = server.sent.map(({ file }) => file).join(' ');
  for (const rarity of RARITIES.split(' ')) expect(names).not.toContain(rarity);
  await page.evaluate(() => document.querySelector('cartoon-smoke')!.setAttribute('style-simplify', '3'));
  await expect.poll(() => server.sent.filter(({ file }) => file.endsWith('simplify.js')).length).toBe(1);
  judge([
    { name: 'simplified light', kB: fetched(server, (file) => isScript(file) && !isThree(file)) - core, limit: 7.4 },
  ]);
});

test('in a worker, which includes its own three.js', async ({ page, openPage, server }) => {
  await openPage('<cartoon-smoke preset="wisp" thread="worker" paused></cartoon-smoke>');
  await stands(page);
  const own = (file: string) => isScript(file) && !file.endsWith('worker.js');
  judge([
    { name: 'page', kB: fetched(server, own), limit: 23.6 },
    { name: 'worker', kB: fetched(server, (file) => file.endsWith('worker.js')), limit: 256 },
  ]);
  expect(server.sent.some(({ file }) => isThree(file))).toBe(false);
});

test('as the single file for CDNs, three.js included', async ({ page, openPage, server }) => {
  const script = '<script type="module" src="/package/dist/cartoon-smoke.min.js"></script>';
  await openPage('<cartoon-smoke preset="wisp" thread="worker" paused></cartoon-smoke>', { script });
  await stands(page);
  judge([{ name: 'embed.cdnKb', kB: fetched(server, isScript), limit: 302.3 }]);
  expect(new Set(server.sent.filter(({ file }) => isScript(file)).map(({ file }) => file)).size).toBe(1);
});

test('of an app that collides with a mesh, a simulator without Rapier beside the core', async ({
  page,
  openPage,
  server,
}) => {
  const script = `<script type="importmap">{ "imports": { "three": "/node_modules/three/build/three.module.js" } }</script>
  <script type="module">
    import { DirectionalLight, Mesh, TorusGeometry, WebGLRenderer } from 'three';
    import { CartoonSmoke } from '/package/dist/index.js';
    const renderer = new WebGLRenderer({ stencil: true });
    const smoke = await CartoonSmoke.create({ renderer, keyLight: new DirectionalLight() });
    smoke.collide(new Mesh(new TorusGeometry()));
    await smoke.complete();
    document.title = 'loaded';
  </script>`;
  await openPage('', { script });
  await expect(page).toHaveTitle('loaded');
  const isMeshes = (file: string) => file.endsWith('meshes/bindings_bg.wasm');
  judge([
    { name: 'collide.meshKb', kB: fetched(server, isMeshes), limit: 213 },
    { name: 'simulators', kB: fetched(server, (file) => file.endsWith('.wasm')), limit: 342.6 },
  ]);
});

test('with rigids, with the physics simulator instead of the core', async ({ page, openPage, server }) => {
  await openPage('<cartoon-smoke preset="lamp" simulation-max-particles="300" paused></cartoon-smoke>');
  await stands(page);
  judge([{ name: 'embed.physicsKb', kB: fetched(server, (file) => file.endsWith('.wasm')), limit: 569.3 }]);
  expect(server.sent.map(({ file }) => file).join()).not.toContain('core/bindings_bg.wasm');
});
