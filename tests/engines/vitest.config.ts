import type { ProvidedContext } from 'vitest';
import { defineConfig } from 'vitest/config';
import { findEngines } from './engines.ts';

const TESTS = 'tests/engines/*.test.ts';
// Here each test starts all engines by itself.
const OF_ALL = 'tests/engines/pictures.test.ts';

// Where an engine is missing, its tests fail in the check and are left out elsewhere: the command says so.
const isCheck = process.env.CI === 'true';
const engines = (await findEngines()).filter(({ path }) => isCheck || path !== undefined);

const project = (name: string, include: string, exclude: string[], provide: Partial<ProvidedContext>) => ({
  extends: true as const,
  test: { name, include: [include], exclude, provide: { engines, ...provide } },
});

/** `npm run test:engines`: each test runs in three browser engines, a project each. */
export default defineConfig({
  test: {
    environment: 'node',
    // A browser keeps one core busy, and the project is made for two.
    maxWorkers: 2,
    allowOnly: false,
    passWithNoTests: false,
    testTimeout: 600_000,
    hookTimeout: 600_000,
    globalSetup: 'tests/engines/servers.ts',
    projects: [
      project('All', OF_ALL, [], {}),
      ...engines.map((engine) => project(engine.title, TESTS, [OF_ALL], { engine })),
    ],
  },
});
