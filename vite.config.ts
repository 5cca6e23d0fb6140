import { fileURLToPath } from 'node:url';
import browserslistToEsbuild from 'browserslist-to-esbuild';
import { defineConfig } from 'vite';
import glsl from 'vite-plugin-glsl';
import { smallThree } from './scripts/patches/three.mjs';
import { addresses, policies, serviceWorker, themeFirst, together } from './scripts/site/plugins.ts';

const source = (name: string) => fileURLToPath(new URL(`src/${name}.ts`, import.meta.url));

/** These files only export. */
const EXPORTING = /\/src\/(index|internal|preset|puff)\.ts$/;
/** What the page needs before its first picture. Without demo/main.ts, which other pages would run with the stage. */
const PARTS = ['notices', 'progress', 'errorScreen'].map((name) => `demo/ui/${name}`);
const FIRST = ['stage/stage', 'page/size', 'page/visibility', ...PARTS];

/** The overlay connects to no other host, except to web sockets of the same machine. */
const OVERLAY_POLICY =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self' ws://127.0.0.1:* ws://localhost:*; base-uri 'none'; form-action 'none'";

/** The demo site. URLs are relative, so that it works in any folder of any host. */
export default defineConfig({
  base: './',
  plugins: [
    glsl(),
    ...smallThree({ hasLoaders: true }),
    addresses(process.env.CARTOON_SMOKE_BASE),
    policies({ '/overlay.html': OVERLAY_POLICY }),
    themeFirst(),
    serviceWorker(),
  ],
  // The examples import the package by its name.
  resolve: {
    alias: [
      { find: /^cartoon-smoke$/, replacement: source('index') },
      { find: /^cartoon-smoke\/(clip|element|fiber|puff)$/, replacement: source('$1') },
    ],
  },
  // All packages that the page and the examples import. Vite would discover those that load on demand late, and then
  // answer 504 for the others.
  optimizeDeps: {
    noDiscovery: true,
    include: [
      'three',
      'three/examples/jsm/controls/OrbitControls.js',
      'three/examples/jsm/exporters/EXRExporter.js',
      ...['DRACO', 'GLTF', 'OBJ'].map((name) => `three/examples/jsm/loaders/${name}Loader.js`),
      '@pmndrs/assets/models/suzi.glb',
      '@react-three/fiber',
      'culori/fn',
      'react',
      'react/jsx-dev-runtime',
      'react-dom/client',
      'fflate',
      'gifenc',
      'jsonc-parser',
      'lean-qr',
      'mediabunny',
    ],
  },
  // The simulator's module imports its bindings dynamically, which the IIFE worker format does not support.
  worker: { format: 'es', plugins: () => [glsl(), ...smallThree()] },
  build: {
    target: browserslistToEsbuild(),
    sourcemap: true,
    chunkSizeWarningLimit: 800,
    rolldownOptions: {
      input: ['index.html', 'paper.html', 'puff.html', 'examples.html', 'overlay.html', 'costs.html'],
      // Otherwise the first load would contain every module that they name.
      treeshake: { moduleSideEffects: [{ test: EXPORTING, sideEffects: false }] },
      output: {
        codeSplitting: {
          // Each file costs a request, so the page's first picture takes few. Other pages need some of the parts.
          groups: [
            { name: 'poster', test: /\/src\/demo\/(poster|mediaQueries)\.ts$/, priority: 2 },
            { name: 'preload', test: /vite\/(preload-helper|modulepreload-polyfill)/, priority: 2 },
            { name: 'dom', test: /\/src\/(demo\/ui\/dom|base\/(errors|timeout))\.ts$/, priority: 3 },
            { name: 'presets', test: /\/src\/parameters\/byScene\/.+\.ts$/, priority: 2 },
            {
              name: together('preset', ['parameters/codec', 'parameters/environment'].map(source), EXPORTING),
              debugName: 'preset',
              priority: 1,
            },
            { name: together('stage', FIRST.map(source), EXPORTING), debugName: 'stage' },
          ],
        },
      },
    },
  },
});
