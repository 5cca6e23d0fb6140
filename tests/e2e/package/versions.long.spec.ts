/** The oldest and the newest release of three.js that the package accepts draw the scene of examples/three alike. */
import { cpSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { findParameter } from '../../../src/parameters/table.ts';
import { bin, expect, expectTitle, expectTypes, PAGE, test, type MakeProject } from '../../support/freshProject.ts';
import { compare } from '../../support/goldens.ts';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const read = (path: string) => readFileSync(join(ROOT, path), 'utf8');
const PINNED = (JSON.parse(read('node_modules/three/package.json')) as { version: string }).version;
test.use({ deviceScaleFactor: 1 });

const LIT = '#fff4e3';
const INK = findParameter('style.inkColor')!.default as string;
/** The example without its clock: the frame after 3 s. */
const MAIN = read('examples/three/main.ts')
  .replace(', Timer', '')
  .replace(/const timer = [^]*?(?=function fit)/, '')
  .replace(/Number\(new URLSearchParams.+ 0\)/, '3')
  .replace('antialias: true', 'antialias: true, preserveDrawingBuffer: true').concat(`
controls.update();
await smoke.complete();
renderer.render(scene, camera);
const hash = smoke.hash();
smoke.dispose();
document.title = hash;
`);
/** The decoder of models has no default path in older releases. */
const SCENE = read('examples/three/scene.ts').replace(
  'new DRACOLoader()',
  "new DRACOLoader().setDecoderPath('./draco/')",
);

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
  let hash = '';
  let picture: Buffer = Buffer.of();
  await expectTitle(page, join(place, 'dist'), /^[0-9a-f]{16}$/, async () => {
    hash = await page.title();
    picture = await page.locator('canvas').screenshot();
  });
  return { hash, picture: PNG.sync.read(picture) };
}

/** Pixels that have this colour in only one of the pictures. */
function moved(one: PNG, other: PNG, color: string): number {
  const rgb = Buffer.from(color.slice(1), 'hex');
  const has = ({ data }: PNG, at: number) => data[at] === rgb[0] && data[at + 1] === rgb[1] && data[at + 2] === rgb[2];
  let count = 0;
  for (let at = 0; at < one.data.length; at += 4) count += Number(has(one, at) !== has(other, at));
  return count;
}

/** The accepted releases of three.js. The package is built before the tests, but after this file is loaded. */
function accepted(): { oldest: string; newest: string } {
  const { peerDependencies } = JSON.parse(read('package/package.json')) as { peerDependencies: { three: string } };
  const [, oldest, newest] = /^>=(0\.\d+\.0) (<1)$/.exec(peerDependencies.three)!;
  return { oldest, newest };
}

for (const which of ['oldest', 'newest'] as const) {
  test(`the ${which} accepted three.js draws what the one of this repository draws`, async ({ page, project }) => {
    const three = accepted()[which];
    const expected = await draw(page, project, PINNED);
    const { hash, picture } = await draw(page, project, three);
    expect(hash).toBe(expected.hash);
    expect(
      moved(picture, new PNG({ width: picture.width, height: picture.height }), LIT),
      'pixels of lit smoke',
    ).toBeGreaterThan(1000);
    for (const color of [LIT, INK]) expect(moved(picture, expected.picture, color), color).toBe(0);
    // Standard materials and shadow maps of three.js have changed a little: 135 pixels of 230,400 since 0.177.
    expect(compare(picture, expected.picture, 8).outliers).toBeLessThan(200);
  });
}

test('the types of the package fit those of the oldest accepted three.js', ({ project }) => {
  const { oldest } = accepted();
  const place = project(['typescript@7', `three@${oldest}`, `@types/three@~${oldest}`], {
    'main.ts': `import { CartoonSmoke } from 'cartoon-smoke';
import { DirectionalLight, Scene, WebGLRenderer } from 'three';

const renderer = new WebGLRenderer({ stencil: true });
const smoke = await CartoonSmoke.create({ renderer, keyLight: new DirectionalLight() });
new Scene().add(smoke);
smoke.emitFrom(new Scene(), { rate: 3 }).remove();
`,
  });
  expectTypes(place, {}, ['main.ts']);
});
