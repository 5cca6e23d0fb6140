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
    testTimeout: isLong ? 600_000 : 30_000,
    passWithNoTests: false,
  },
});
