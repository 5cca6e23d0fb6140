import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import glsl from 'vite-plugin-glsl';
import { withoutShaders } from './scripts/package/withoutShaders.mjs';
import { addresses, preloads, serviceWorker } from './scripts/site/plugins.ts';

const source = (name: string) => fileURLToPath(new URL(`src/${name}.ts`, import.meta.url));

/** The demo site. URLs are relative, so that it works in any folder of any host. */
export default defineConfig({
  base: './',
  plugins: [
    glsl(),
    withoutShaders(),
    addresses(process.env.CARTOON_SMOKE_BASE),
    preloads('/src/app/ahead.ts', '/src/app/main.ts'),
    serviceWorker(),
  ],
  // The examples import the package by its name.
  resolve: {
    alias: [
      { find: /^cartoon-smoke$/, replacement: source('index') },
      { find: /^cartoon-smoke\/element$/, replacement: source('element/define') },
      { find: /^cartoon-smoke\/(fiber|puff)$/, replacement: source('$1') },
    ],
  },
  // Vite would discover these late, in modules that only tests import or that load on demand, and reload the page.
  optimizeDeps: {
    include: [
      'three',
      'three/examples/jsm/loaders/GLTFLoader.js',
      'three/examples/jsm/loaders/OBJLoader.js',
      'fflate',
      'gifenc',
      'mediabunny',
    ],
  },
  // The simulator's module imports its bindings dynamically, which the IIFE worker format does not support.
  worker: { format: 'es', plugins: () => [glsl(), withoutShaders()] },
  build: {
    target: 'es2023',
    sourcemap: true,
    chunkSizeWarningLimit: 800,
    rolldownOptions: {
      input: ['index.html', 'paper.html', 'puff.html', 'examples.html'],
      // These files only export. Otherwise the first load would contain every module that they name.
      treeshake: { moduleSideEffects: [{ test: /\/src\/(index|internal|preset|puff)\.ts$/, sideEffects: false }] },
      // puff.html loads presets one by one, which would split those of the page into a file for each scene.
      output: { codeSplitting: { groups: [{ name: 'presets', test: /\/src\/preset\/byScene\/.+\.ts$/ }] } },
    },
  },
});
