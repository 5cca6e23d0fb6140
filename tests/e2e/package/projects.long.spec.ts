/** The package as a new user installs it: packed by npm, in projects outside this repository. */
import { readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type * as Vite from 'vite';
import { bin, expect, expectTitle, expectTypes, PAGE, PAGE_WITH_ELEMENT, test } from '../../support/freshProject.ts';

const MAIN = `import 'cartoon-smoke/element';
import { CartoonSmokeElement, ParameterError } from 'cartoon-smoke';
import { decode, table } from 'cartoon-smoke/preset';

const smoke = document.querySelector('cartoon-smoke')!;
const isOne: boolean = smoke instanceof CartoonSmokeElement;
smoke.addEventListener('error', ({ detail }) => (document.title = detail.error.message));
smoke.addEventListener('ready', async ({ detail }) => {
  smoke.emissionRate = 20;
  const { state } = await decode('#v=1&preset=wisp');
  const error: unknown = await smoke.set({ 'emission.rate': -1 }).catch((thrown: unknown) => thrown);
  document.title = [detail.thread, isOne, table.length > 100, state.preset, error instanceof ParameterError].join();
});
`;
const READY = 'worker,true,true,wisp,true';

test('a page without a bundler', async ({ page, project }) => {
  const map = '{ "imports": { "three": "./node_modules/three/build/three.module.js" } }';
  const listen = `document.querySelector('cartoon-smoke').addEventListener('ready', () => (document.title = 'Smoke'));`;
  const scripts = `<script type="importmap">${map}</script>
    <script type="module">import './node_modules/cartoon-smoke/dist/element.js'; ${listen}</script>`;
  await expectTitle(page, project([], { 'index.html': PAGE_WITH_ELEMENT + scripts }), 'Smoke');
});

for (const version of ['7', '8']) {
  test(`Vite ${version} without configuration, built and on its development server`, async ({ page, project }) => {
    const body = PAGE_WITH_ELEMENT.replace('preset=', 'emision-rate="1" preset=');
    const main = `${body}<script type="module" src="/main.ts"></script>`;
    const place = project([`vite@${version}`], { 'index.html': main, 'main.ts': MAIN });
    const warnings: string[] = [];
    page.on('console', (message) => message.text().includes('emision-rate') && warnings.push(message.text()));
    bin(place, 'vite/bin/vite.js', 'build');
    await expectTitle(page, join(place, 'dist'), READY);
    expect(warnings).toEqual([]);
    const { createServer } = (await import(join(place, 'node_modules/vite/dist/node/index.js'))) as typeof Vite;
    const server = await createServer({ root: place, logLevel: 'error', server: { port: 0 } });
    await server.listen();
    await page.goto(server.resolvedUrls!.local[0]);
    await expect(page).toHaveTitle(READY);
    // The server may reload the page when it has bundled the dependencies.
    expect(new Set(warnings).size).toBe(1);
    await server.close();
  });
}

test('webpack without configuration', async ({ page, project }) => {
  const place = project(['webpack', 'webpack-cli'], { 'main.js': withoutTypes(MAIN) });
  bin(place, 'webpack/bin/webpack.js', './main.js', '--mode', 'production');
  writeFileSync(join(place, 'dist/index.html'), `${PAGE_WITH_ELEMENT}<script src="main.js"></script>`);
  await expectTitle(page, join(place, 'dist'), READY);
});

const URLS = `import core from 'cartoon-smoke/core.wasm';
import physics from 'cartoon-smoke/physics.wasm';
import { setAssetUrls } from 'cartoon-smoke';
setAssetUrls({ core, physics, worker: 'worker.js' });
`;
const ESBUILD = `import { build } from 'esbuild';
const entryPoints = [{ in: 'main.ts', out: 'main' }, { in: 'cartoon-smoke/worker.js', out: 'worker' }];
const loader = { '.wasm': 'file' };
await build({ entryPoints, bundle: true, format: 'esm', outdir: 'dist', publicPath: '/', loader });
`;

test('esbuild, which copies no files by itself', async ({ page, project }) => {
  const place = project(['esbuild'], { 'main.ts': URLS + MAIN, 'build.mjs': ESBUILD });
  bin(place, '../build.mjs');
  writeFileSync(join(place, 'dist/index.html'), `${PAGE_WITH_ELEMENT}<script type="module" src="main.js"></script>`);
  await expectTitle(page, join(place, 'dist'), READY);
});

const ROLLUP = `import resolve from '@rollup/plugin-node-resolve';
import url from '@rollup/plugin-url';

export default {
  input: { main: 'main.js', worker: 'cartoon-smoke/worker.js' },
  output: { dir: 'dist', format: 'es' },
  plugins: [resolve(), url({ include: '**/*.wasm', limit: 0, publicPath: '/' })],
};
`;

test('Rollup, with the plugins that find packages and copy files', async ({ page, project }) => {
  const place = project(['rollup@4', '@rollup/plugin-node-resolve@16', '@rollup/plugin-url@8'], {
    'main.js': URLS + withoutTypes(MAIN),
    'rollup.config.js': ROLLUP,
  });
  bin(place, 'rollup/dist/bin/rollup', '--config');
  writeFileSync(join(place, 'dist/index.html'), `${PAGE_WITH_ELEMENT}<script type="module" src="main.js"></script>`);
  await expectTitle(page, join(place, 'dist'), READY);
});

const PARTS = `export * as index from 'cartoon-smoke';
export * as fiber from 'cartoon-smoke/fiber';
export * as puff from 'cartoon-smoke/puff';
import 'cartoon-smoke/element';
`;
const FIBER = ['@react-three/fiber@9', 'react@19', 'react-dom@19'];
/** Text of a warning of each entry. */
const WARNINGS = ['was read from a promise', 'update() was never called', 'The target is null', 'matches no element'];
const config = (conditions: string) => `import resolve from '@rollup/plugin-node-resolve';
import commonjs from '@rollup/plugin-commonjs';

export default {
  input: 'main.js',
  output: { dir: 'dist', format: 'es' },
  external: /^(react|@react-three)/,
  plugins: [resolve({ exportConditions: [${conditions}] }), commonjs()],
};
`;
const bundlers = {
  esbuild: {
    packages: ['esbuild'],
    build: (place: string, isDevelopment: boolean) => {
      const options = `{ entryPoints: ['main.js'], bundle: true, format: 'esm', outdir: 'dist', loader: { '.wasm': 'file' }, conditions: ${isDevelopment ? "['development']" : '[]'} }`;
      writeFileSync(join(place, 'build.mjs'), `import { build } from 'esbuild';\nawait build(${options});\n`);
      bin(place, '../build.mjs');
    },
  },
  rollup: {
    packages: ['rollup@4', '@rollup/plugin-node-resolve@16', '@rollup/plugin-commonjs@28'],
    build: (place: string, isDevelopment: boolean) => {
      writeFileSync(join(place, 'rollup.config.js'), config(isDevelopment ? "'development'" : ''));
      bin(place, 'rollup/dist/bin/rollup', '--config');
    },
  },
  webpack: {
    packages: ['webpack', 'webpack-cli'],
    build: (place: string, isDevelopment: boolean) => {
      const mode = isDevelopment ? 'development' : 'production';
      bin(place, 'webpack/bin/webpack.js', './main.js', '--mode', mode, '--devtool', 'source-map');
    },
  },
  vite: {
    packages: ['vite@8'],
    build: (place: string, isDevelopment: boolean) => {
      const environment = isDevelopment ? `process.env.NODE_ENV = 'development';` : '';
      writeFileSync(
        join(place, 'vite.config.js'),
        `${environment} export default { build: { rollupOptions: { input: 'main.js', preserveEntrySignatures: 'strict' } } };`,
      );
      bin(place, 'vite/bin/vite.js', 'build', '--mode', isDevelopment ? 'development' : 'production');
    },
  },
} as const;

for (const [name, { packages, build }] of Object.entries(bundlers)) {
  test(`${name} bundles warnings in development only`, ({ project }) => {
    const place = project([...packages, ...FIBER], { 'main.js': PARTS });
    for (const isDevelopment of [true, false]) {
      rmSync(join(place, 'dist'), { recursive: true, force: true });
      build(place, isDevelopment);
      const dist = readdirSync(join(place, 'dist'), { recursive: true, encoding: 'utf8' });
      const scripts = dist.filter((file) => file.endsWith('.js'));
      const code = scripts.map((file) => readFileSync(join(place, 'dist', file), 'utf8')).join('\n');
      expect(WARNINGS.filter((text) => code.includes(text))).toEqual(isDevelopment ? WARNINGS : []);
    }
  });
}

const ANGULAR = {
  'angular.json': JSON.stringify({
    version: 1,
    projects: {
      app: {
        root: '',
        projectType: 'application',
        architect: {
          build: {
            builder: '@angular/build:application',
            options: {
              browser: 'main.ts',
              index: 'index.html',
              tsConfig: 'tsconfig.json',
              outputPath: 'dist',
              assets: [
                {
                  glob: '{worker.js,stageModel.js,wasm/**}',
                  input: 'node_modules/cartoon-smoke/dist',
                  output: 'cartoon-smoke',
                },
              ],
              progress: false,
            },
          },
        },
      },
    },
    cli: { analytics: false },
  }),
  'tsconfig.json': JSON.stringify({
    compilerOptions: {
      strict: true,
      target: 'es2022',
      module: 'es2022',
      moduleResolution: 'bundler',
      skipLibCheck: true,
      experimentalDecorators: true,
    },
    angularCompilerOptions: { strictTemplates: true },
    files: ['main.ts'],
  }),
  'index.html': `${PAGE}<smoke-page></smoke-page>`,
  'main.ts': `import 'cartoon-smoke/element';
import { setAssetUrls, type CartoonSmokeElement, type SmokeEvents } from 'cartoon-smoke';
import { Component, CUSTOM_ELEMENTS_SCHEMA, ElementRef, provideZonelessChangeDetection, viewChild } from '@angular/core';
import { bootstrapApplication } from '@angular/platform-browser';

setAssetUrls({
  core: 'cartoon-smoke/wasm/core/bindings_bg.wasm',
  physics: 'cartoon-smoke/wasm/physics/bindings_bg.wasm',
  worker: 'cartoon-smoke/worker.js',
});

@Component({
  selector: 'smoke-page',
  schemas: [CUSTOM_ELEMENTS_SCHEMA],
  template: '<cartoon-smoke #smoke preset="wisp" [emissionRate]="12" style="display: block; height: 200px" (ready)="show($event)"></cartoon-smoke>',
})
class SmokePage {
  readonly smoke = viewChild.required<ElementRef<CartoonSmokeElement>>('smoke');

  show({ detail }: CustomEvent<SmokeEvents['ready']>): void {
    document.title = [detail.thread, this.smoke().nativeElement.emissionRate].join();
  }
}

bootstrapApplication(SmokePage, { providers: [provideZonelessChangeDetection()] });
`,
};

test('Angular, whose builder copies no WASM', async ({ page, project }) => {
  const packages = ['build', 'cli', 'common', 'compiler', 'compiler-cli', 'core', 'platform-browser'];
  const all = [
    ...packages.map((name) => `@angular/${name}@20`),
    'rxjs@7',
    'tslib@2',
    'typescript@5.9',
    '@types/three@0.187',
  ];
  const place = project(all, ANGULAR);
  bin(place, '@angular/cli/bin/ng.js', 'build');
  await expectTitle(page, join(place, 'dist/browser'), 'worker,12');
});

function withoutTypes(program: string): string {
  return program.replace(/!;|: boolean|: unknown/g, (type) => (type === '!;' ? ';' : ''));
}

test('TypeScript in its strictest mode, including the declarations of the package', ({ project }) => {
  const place = project(['typescript@7', '@types/three@0.187'], { 'main.ts': MAIN });
  expectTypes(place, {}, ['main.ts']);
});
