import { defineConfig } from 'vitest/config';
import glsl from 'vite-plugin-glsl';

const isLong = Boolean(process.env.TEST_LONG);
const LONG = 'tests/unit/**/*.long.test.ts';

/** Tests that need no browser. Those named *.long.test.ts run by `npm run test:long` only. */
export default defineConfig({
  plugins: [glsl()],
  test: {
    include: isLong ? [LONG] : ['tests/unit/**/*.test.ts'],
    exclude: isLong ? [] : [LONG],
    environment: 'node',
    allowOnly: false,
    // Long enough for the slowest of machines, as in playwright.config.ts.
    testTimeout: 600_000,
    hookTimeout: 600_000,
    passWithNoTests: false,
  },
});
