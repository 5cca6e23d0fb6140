import { availableParallelism } from 'node:os';
import { defineConfig } from 'vitest/config';
import glsl from 'vite-plugin-glsl';

const isLong = Boolean(process.env.TEST_LONG);
const LONG = 'tests/unit/**/*.long.test.ts';
// These measure the memory of the simulator's module, which other files would have used before.
const ISOLATED = ['tests/unit/simLife.test.ts'];
const include = isLong ? [LONG] : ['tests/unit/**/*.test.ts'];
const exclude = isLong ? [] : [LONG];

/** Tests that need no browser. Those named *.long.test.ts run by `npm run test:long` only. */
export default defineConfig({
  plugins: [glsl()],
  test: {
    environment: 'node',
    pool: 'threads',
    maxWorkers: availableParallelism(),
    allowOnly: false,
    // Long enough for the slowest of machines, as in playwright.config.ts.
    testTimeout: 600_000,
    hookTimeout: 600_000,
    passWithNoTests: false,
    projects: [
      // Loading the modules anew for each file takes longer than most tests.
      { extends: true, test: { name: 'shared', include, exclude: [...exclude, ...ISOLATED], isolate: false } },
      ...(isLong ? [] : [{ extends: true as const, test: { name: 'isolated', include: ISOLATED } }]),
    ],
  },
});
