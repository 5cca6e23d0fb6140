import { fileURLToPath } from 'node:url';
import { defineConfig, mergeConfig } from 'vite';
import site from '../vite.config.ts';

const PAGES = ['three', 'react', 'landing', 'article'];
/** Plugins for the demo page alone; examples draw with materials of three.js, too. */
const OF_THE_PAGE = ['service-worker', 'without-shaders'];
const ROOT = fileURLToPath(new URL('..', import.meta.url));

/**
 * The examples, into the folder of a site that is built already. By themselves, because React Three Fiber wants all of
 * three.js, and what is bundled together is shared: every visitor of the demo would fetch it.
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
