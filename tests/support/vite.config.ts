import { fileURLToPath } from 'node:url';
import { mergeConfig } from 'vite';
import site from '../../vite.config.ts';

/** The development server as the tests want it: nothing reloads a page in the middle of a test. */
export default mergeConfig(site, {
  root: fileURLToPath(new URL('../..', import.meta.url)),
  cacheDir: '.cache/vite-tests',
  server: { host: '127.0.0.1', hmr: false, watch: null },
});
