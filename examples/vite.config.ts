import { fileURLToPath } from 'node:url';
import { defineConfig, mergeConfig } from 'vite';
import site from '../vite.config.ts';

const PAGES = ['three', 'react', 'landing', 'article'];
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
  config.plugins = config.plugins?.filter((plugin: { name?: string }) => plugin.name !== 'service-worker');
  return config;
});
