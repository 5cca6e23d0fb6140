import { defineConfig } from 'vitest/config';
import { findEngines } from './engines.ts';

const engines = await findEngines();
// Where an engine is missing, its tests fail in the check and are left out elsewhere: the command says so.
const isCheck = process.env.CI === 'true';

/** `npm run test:engines`: each test runs in three browser engines, a project each. */
export default defineConfig({
  test: {
    // A browser keeps one core busy, and the project is made for two.
    maxWorkers: 2,
    allowOnly: false,
    passWithNoTests: false,
    globalSetup: 'tests/engines/servers.ts',
    projects: engines
      .filter(({ path }) => isCheck || path !== undefined)
      .map((engine) => ({
        extends: true,
        test: {
          name: engine.title,
          include: ['tests/engines/**/*.test.ts'],
          environment: 'node',
          testTimeout: 600_000,
          hookTimeout: 600_000,
          provide: { engine },
        },
      })),
  },
});
