import { availableParallelism } from 'node:os';
import { defineConfig } from 'vitest/config';
import glsl from 'vite-plugin-glsl';

const isLong = Boolean(process.env.TEST_LONG);
const LONG = 'tests/unit/**/*.long.test.ts';
// No other file may use their modules before: the first measures the memory of the simulator's, the second replaces one.
// The others replace globals, or need those of Node.
const ISOLATED = [
  'tests/unit/simulator/life.test.ts',
  'tests/unit/renderer/completion.test.ts',
  'tests/unit/page/element/simulated.test.ts',
  'tests/unit/stage/remote/startWorker.test.ts',
  'tests/unit/scripts/devServers.test.ts',
];
const include = isLong ? [LONG] : ['tests/unit/**/*.test.ts'];
const exclude = isLong ? [] : [LONG];

/** Tests without a browser. Files named *.long.test.ts run only in `npm run test:long`. */
export default defineConfig({
  plugins: [glsl()],
  test: {
    environment: 'node',
    pool: 'threads',
    maxWorkers: availableParallelism(),
    allowOnly: false,
    // Sufficient for slow machines, as in playwright.config.ts.
    testTimeout: 600_000,
    hookTimeout: 600_000,
    passWithNoTests: false,
    projects: [
      // Reloading the modules for each file would take longer than most tests.
      { extends: true, test: { name: 'shared', include, exclude: [...exclude, ...ISOLATED], isolate: false } },
      ...(isLong ? [] : [{ extends: true as const, test: { name: 'isolated', include: ISOLATED } }]),
    ],
  },
});
