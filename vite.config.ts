import { defineConfig } from 'vite';
import glsl from 'vite-plugin-glsl';
import { withoutShaders } from './scripts/package/withoutShaders.mjs';
import { addresses } from './scripts/site/addresses.ts';
import { preloads } from './scripts/site/preloads.ts';
import { serviceWorker } from './scripts/site/serviceWorker.ts';

/** The demo site: relative addresses, so that it works from any folder of any host. */
export default defineConfig({
  base: './',
  plugins: [
    glsl(),
    withoutShaders(),
    addresses(process.env.CARTOON_SMOKE_BASE),
    preloads('/src/app/main.ts'),
    serviceWorker(),
  ],
  // Found too late otherwise, by a module that only a test imports or that comes on demand, and the page would reload.
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
  // The simulator's module loads its bindings on demand, which the older worker format cannot.
  worker: { format: 'es', plugins: () => [glsl(), withoutShaders()] },
  build: {
    target: 'es2023',
    sourcemap: true,
    chunkSizeWarningLimit: 800,
    rolldownOptions: { input: ['index.html', 'paper.html'] },
  },
});
