/** The example of docs/fiber.md in a new project with Vite: types, StrictMode, the server, and smoke in the picture. */
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import { findParameter } from '../../../src/parameters/table.ts';
import { bin, expect, expectTitle, expectTypes, PAGE, test } from '../../support/freshProject.ts';
import { pixelsOf } from '../../support/pictures.ts';

const [, EXAMPLE] = /```tsx\n([^]+?)```/.exec(
  readFileSync(new URL('../../../docs/fiber.md', import.meta.url), 'utf8'),
)!;
/** The example in StrictMode, with a title when it is ready. */
const MAIN = `import { StrictMode } from 'react';\n${EXAMPLE}`
  .replace('<Canvas', '<StrictMode><Canvas')
  .replace('</Canvas>', '</Canvas></StrictMode>')
  .replace('<Smoke ', "<Smoke onReady={() => (document.title = 'Smoke')} ");
const SMOKE = findParameter('style.smokeColor')!.default as string;
const STYLE = '<style>html, body, #root { height: 100%; margin: 0; background: #446 }</style>';
const JSX = { jsx: 'react-jsx' };

// Fiber draws at least one pixel per CSS pixel.
test.use({ deviceScaleFactor: 1 });

test('the example of docs/fiber.md has less than 25 lines, exact types, and draws smoke', async ({ page, project }) => {
  expect(EXAMPLE.trim().split('\n').length).toBeLessThan(25);
  const packages = ['vite@8', 'typescript@7', 'react@19', 'react-dom@19', '@react-three/fiber@9'];
  const types = ['@types/react@19', '@types/react-dom@19', '@types/three@0.187'];
  const place = project([...packages, ...types], {
    'index.html': `${PAGE}${STYLE}<div id="root"></div><script type="module" src="/main.tsx"></script>`,
    'main.tsx': MAIN,
    'wrong.tsx': `import { Emitter } from 'cartoon-smoke/fiber';\nexport const wrong = <Emitter sped={3} />;\n`,
    'server.mjs': `import * as fiber from 'cartoon-smoke/fiber';\nconsole.log(Object.keys(fiber).join());\n`,
  });
  // The declarations of Fiber itself fail with the strictest options.
  expectTypes(place, { ...JSX, skipLibCheck: true }, ['main.tsx']);
  expect(() => expectTypes(place, { ...JSX, skipLibCheck: true }, ['wrong.tsx'])).toThrow('sped');
  const said = execFileSync(process.execPath, ['server.mjs'], { cwd: place, encoding: 'utf8' });
  expect(said.trim()).toBe('Caster,Collider,Emitter,Smoke,useSmoke');
  writeFileSync(join(place, 'tsconfig.json'), JSON.stringify({ compilerOptions: JSX }));
  bin(place, 'vite/bin/vite.js', 'build');
  await expectTitle(page, join(place, 'dist'), 'Smoke', async () => {
    // Lit smoke has exactly its colour.
    await expect.poll(() => pixelsOf(page, SMOKE)).toBeGreaterThan(500);
  });
});

/** What the share sheet's code has of a page; tests/site/snippet.spec.ts compares the code for three.js with the page. */
const SCENE = {
  values: { 'emission.rate': 60, 'emitters.0.position.y': -0.5, seed: 9, 'style.smokeColor': '#e01020' },
  eye: [0, 0.5, 4],
  centre: [0, 0.5, 0],
  fieldOfView: 40,
  light: [3, 5, 6],
  background: '#224466',
} as const;
const EMBED = {
  width: 400,
  ratio: [4, 3],
  isTransparent: false,
  isInteractive: true,
  alt: 'Smoke',
  hasPoster: false,
} as const;

test('the code of the share sheet for Fiber and for three.js has the same smoke', async ({ page, project }) => {
  await page.goto('/tests/support/blank.html');
  const code = await page.evaluate(
    async ([scene, embed, path]) => {
      const { fiberCode, threeCode } = (await import(path)) as typeof import('../../../src/demo/share/sceneCode.ts');
      return { fiber: fiberCode(scene, embed), three: threeCode(scene, embed) };
    },
    [SCENE, EMBED, '/src/demo/share/sceneCode.ts'] as const,
  );
  const fiber = code.fiber.replace('<Smoke ', '<Smoke ref={(smoke) => (window.fiber = smoke)} ');
  const main = `import './three.js';
import { createRoot } from 'react-dom/client';
import { SmokeScene } from './fiber.jsx';
createRoot(document.getElementById('root')).render(<SmokeScene />);
`;
  const packages = ['vite@8', 'react@19', 'react-dom@19', '@react-three/fiber@9', '@react-three/drei@10'];
  const place = project(packages, {
    'index.html': `${PAGE}<div id="root"></div><script type="module" src="/main.jsx"></script>`,
    'main.jsx': main,
    'fiber.jsx': fiber,
    'three.js': `${code.three}\nrenderer.setAnimationLoop(null);\nwindow.three = smoke;\n`,
    'tsconfig.json': JSON.stringify({ compilerOptions: JSX }),
  });
  bin(place, 'vite/bin/vite.js', 'build');
  await expectTitle(page, join(place, 'dist'), 'Waiting', async () => {
    await page.waitForFunction(() => Boolean(Reflect.get(window, 'fiber') && Reflect.get(window, 'three')));
    const hashes = await page.evaluate(() =>
      ['fiber', 'three'].map((name) => {
        const smoke = Reflect.get(window, name) as CartoonSmoke;
        smoke.step(600 - smoke.stats.steps);
        return [smoke.hash(), smoke.stats.alive > 100];
      }),
    );
    expect(hashes[0]).toEqual(hashes[1]);
    expect(hashes[0][1]).toBe(true);
    await expect.poll(() => pixelsOf(page, '#e01020')).toBeGreaterThan(300);
  });
});
