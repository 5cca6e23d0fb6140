/** The package as a new user tries it: packed by npm, installed into projects that know nothing of this one. */
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { expect, test, type Server } from '../support/embed.ts';
import { script } from '../support/server.ts';

const PACKAGE = fileURLToPath(new URL('../../package', import.meta.url));
const ELEMENT = '<cartoon-smoke preset="wisp" simulation-max-particles="300" style="height: 200px"></cartoon-smoke>';
const PAGE = `<!doctype html><html lang="en"><meta charset="utf-8"><title>Waiting</title><link rel="icon" href="data:,">${ELEMENT}`;
const MAIN = `import 'cartoon-smoke/element';
import { CartoonSmokeElement, ParameterError } from 'cartoon-smoke';
import { decode, table } from 'cartoon-smoke/preset';

const smoke = document.querySelector('cartoon-smoke')!;
const isOne: boolean = smoke instanceof CartoonSmokeElement;
smoke.addEventListener('error', ({ detail }) => (document.title = detail.error.message));
smoke.addEventListener('ready', async ({ detail }) => {
  const { state } = await decode('#v=1&preset=wisp');
  const refusal: unknown = await smoke.set({ 'emission.rate': -1 }).catch((error: unknown) => error);
  document.title = [detail.thread, isOne, table.length > 100, state.preset, refusal instanceof ParameterError].join();
});
`;
const READY = 'worker,true,true,wisp,true';

let archive: string;
let folder: string;

test.beforeAll(({ server }) => {
  expect(server.address).toBeTruthy();
  folder = mkdtempSync(join(tmpdir(), 'cartoon-smoke-project-'));
  execFileSync('npm', ['pack', '--silent', '--pack-destination', folder], { cwd: PACKAGE, stdio: 'ignore' });
  archive = join(
    folder,
    readdirSync(folder).find((name) => name.endsWith('.tgz'))!,
  );
});
test.afterAll(() => rmSync(folder, { recursive: true }));

/** A project with these packages beside ours. */
function project(name: string, packages: readonly string[], files: Readonly<Record<string, string>>): string {
  const place = join(folder, name);
  mkdirSync(place);
  writeFileSync(join(place, 'package.json'), '{ "private": true, "type": "module" }');
  for (const [file, text] of Object.entries(files)) writeFileSync(join(place, file), text);
  execFileSync('npm', ['install', '--silent', '--no-audit', '--no-fund', archive, 'three@0.187', ...packages], {
    cwd: place,
    stdio: 'ignore',
  });
  return place;
}

function bin(place: string, command: string, ...parameters: string[]): void {
  execFileSync(process.execPath, [join(place, 'node_modules', command), ...parameters], { cwd: place, stdio: 'pipe' });
}

async function expectSmoke(page: Page, place: string, title = READY): Promise<void> {
  const { serveSite } = await script<{ serveSite(folder: string, place: string): Promise<Server> }>('site/serve.mjs');
  const server = await serveSite(place, '/');
  await page.goto(server.address);
  await expect(page).toHaveTitle(title, { timeout: 60_000 });
  await server.close();
}

test('a page without a bundler', async ({ page }) => {
  const map = '{ "imports": { "three": "./node_modules/three/build/three.module.js" } }';
  const listen = `document.querySelector('cartoon-smoke').addEventListener('ready', () => (document.title = 'Smoke'));`;
  const scripts = `<script type="importmap">${map}</script>
    <script type="module">import './node_modules/cartoon-smoke/dist/element.js'; ${listen}</script>`;
  const place = project('plain', [], { 'index.html': PAGE + scripts });
  await expectSmoke(page, place, 'Smoke');
});

for (const version of ['7', '8']) {
  test(`Vite ${version}, as it comes`, async ({ page }) => {
    const main = `${PAGE}<script type="module" src="/main.ts"></script>`;
    const place = project(`vite${version}`, [`vite@${version}`], { 'index.html': main, 'main.ts': MAIN });
    bin(place, 'vite/bin/vite.js', 'build');
    await expectSmoke(page, join(place, 'dist'));
  });
}

test('webpack, as it comes', async ({ page }) => {
  const main = MAIN.replace(/!;|: boolean|: unknown/g, (type) => (type === '!;' ? ';' : ''));
  const place = project('webpack', ['webpack', 'webpack-cli'], { 'main.js': main });
  bin(place, 'webpack/bin/webpack.js', './main.js', '--mode', 'production');
  writeFileSync(join(place, 'dist/index.html'), `${PAGE}<script src="main.js"></script>`);
  await expectSmoke(page, join(place, 'dist'));
});

test('TypeScript at its strictest, the declarations of the package included', () => {
  const options = {
    strict: true,
    exactOptionalPropertyTypes: true,
    noUncheckedIndexedAccess: true,
    skipLibCheck: false,
  };
  const settings = { ...options, target: 'es2023', lib: ['es2023', 'dom', 'dom.iterable'], types: [], noEmit: true };
  const place = project('strict', ['typescript@7', '@types/three@0.187'], { 'main.ts': MAIN });
  for (const [module, moduleResolution] of [
    ['nodenext', 'nodenext'],
    ['esnext', 'bundler'],
  ]) {
    const config = { compilerOptions: { ...settings, module, moduleResolution }, include: ['main.ts'] };
    writeFileSync(join(place, 'tsconfig.json'), JSON.stringify(config));
    bin(place, 'typescript/bin/tsc', '-p', '.');
  }
});
