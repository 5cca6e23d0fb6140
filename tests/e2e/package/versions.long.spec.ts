/** The oldest and the newest release of three.js that the package accepts draw the scene of examples/three alike. */
import { cpSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { bin, expect, expectTitle, expectTypes, PAGE, test, type MakeProject } from '../../support/freshProject.ts';
import { compare } from '../../support/goldens.ts';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const read = (path: string) => readFileSync(join(ROOT, path), 'utf8');
const { peerDependencies } = JSON.parse(read('package/package.json')) as { peerDependencies: { three: string } };
const [, OLDEST] = /^>=(0\.\d+)\.0 <1$/.exec(peerDependencies.three)!;
const PINNED = (JSON.parse(read('node_modules/three/package.json')) as { version: string }).version;
/** The example without its clock: the frame after 3 s. */
const MAIN = read('examples/three/main.ts')
  .replace(', Timer', '')
  .replace(/const timer = [^]*?(?=function fit)/, '')
  .replace(/Number\(new URLSearchParams.+ 0\)/, '3')
  .replace('antialias: true', 'antialias: true, preserveDrawingBuffer: true')
  .concat(`
controls.update();
await smoke.complete();
renderer.render(scene, camera);
document.title = smoke.hash();
`);
/** The decoder of models has no default path in older releases. */
const SCENE = read('examples/three/scene.ts').replace('new DRACOLoader()', "new DRACOLoader().setDecoderPath('./draco/')");

/** Draws the scene with a release of three.js. */
async function draw(page: Page, project: MakeProject, three: string): Promise<{ hash: string; picture: PNG }> {
  const place = project([`three@${three}`, 'vite@8', '@pmndrs/assets@1'], {
    'index.html': `${PAGE}<style>body { margin: 0 }</style><body><script type="module" src="/main.ts"></script></body>`,
    'main.ts': MAIN,
    'scene.ts': SCENE,
    'tentacle.ts': read('examples/three/tentacle.ts'),
  });
  cpSync(join(place, 'node_modules/three/examples/jsm/libs/draco'), join(place, 'public/draco'), { recursive: true });
  bin(place, 'vite/bin/vite.js', 'build');
  let drawn = { hash: '', picture: Buffer.of() };
  await expectTitle(page, join(place, 'dist'), /^[0-9a-f]{16}$/, async () => {
    drawn = { hash: await page.title(), picture: await page.locator('canvas').screenshot() };
  });
  return { hash: drawn.hash, picture: PNG.sync.read(drawn.picture) };
}

for (const [which, three] of [
  ['oldest', `${OLDEST}.0`],
  ['newest', '<1'],
]) {
  test(`the ${which} accepted three.js draws what the one of this repository draws`, async ({ page, project }) => {
    const expected = await draw(page, project, PINNED);
    const { hash, picture } = await draw(page, project, three);
    expect(hash).toBe(expected.hash);
    const { outliers, largest } = compare(picture, expected.picture, 8);
    console.log(which, outliers, largest);
  });
}
