import { fileURLToPath } from 'node:url';
import { defineConfig, mergeConfig } from 'vite';
import site from '../vite.config.ts';

const PAGES = [
  'three',
  'react',
  'game',
  'ring-game',
  'lantern',
  'vite',
  'product',
  'scroll',
  'landing',
  'article',
  'flipbook',
];
/** Plugins for the demo page only; examples also draw with three.js materials. */
const OF_THE_PAGE = ['service-worker', 'without-shaders', 'without-headsets', 'without-json'];
const ROOT = fileURLToPath(new URL('..', import.meta.url));

/**
 * Builds the examples into the folder of an existing site. As a separate build, because React Three Fiber uses all of
 * three.js and chunks are shared within a build: every visitor of the demo would download it.
 */
export default defineConfig(() => {
  const config = mergeConfig(site, {
    root: ROOT,
    publicDir: false,
    build: { emptyOutDir: false, assetsDir: 'examples/assets' },
  });
  config.build.rolldownOptions = { input: PAGES.map((name) => `examples/${name}/index.html`) };
  config.plugins = config.plugins?.filter(({ name }: { name?: string }) => !OF_THE_PAGE.includes(String(name)));
  return config;
});
