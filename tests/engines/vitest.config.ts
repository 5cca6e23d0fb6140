import { defineConfig } from 'vitest/config';

/** What holds in three browser engines: `npm run test:engines`. */
export default defineConfig({
  test: {
    include: ['tests/engines/**/*.test.ts'],
    environment: 'node',
    allowOnly: false,
    testTimeout: 600_000,
    hookTimeout: 600_000,
    passWithNoTests: false,
  },
});
