import { mergeConfig } from 'vite';
import tests from '../support/vite.config.ts';

/**
 * The tests' server for measurements: cross-origin isolated pages have a clock resolution of 5 instead of 100
 * microseconds.
 */
export default mergeConfig(tests, {
  cacheDir: '.cache/vite-bench',
  optimizeDeps: { include: ['@dimforge/rapier3d-compat', 'three.quarks'] },
  server: {
    headers: {
      'Cross-Origin-Opener-Policy': 'same-origin',
      'Cross-Origin-Embedder-Policy': 'require-corp',
    },
  },
});
