import type { ProvidedContext } from 'vitest';
import { defineConfig } from 'vitest/config';
import { findEngines } from './engines.ts';

const TESTS = 'tests/engines/*.test.ts';
// Each of these tests starts all engines itself.
const OF_ALL = 'tests/engines/pictures.test.ts';

// The tests of a missing engine fail in CI. Elsewhere they are skipped, and the command reports it.
const isCheck = process.env.CI === 'true';
const engines = (await findEngines()).filter(({ path }) => isCheck || path !== undefined);

/**
 * JavaScriptCore on Linux (seen in WebKitGTK 2.50.6) compiles WASM to code that keeps live values below the stack
 * pointer, where the signals that suspend the thread overwrite them. About 1 in 1,000 runs of a scene with Rapier then
 * ends in another state or in a fault. Compare https://bugs.webkit.org/show_bug.cgi?id=299586. Safari suspends threads
 * without signals. A wrong result of our own appears in each attempt.
 */
const ATTEMPTS_AGAIN = { WebKit: 1, All: 1 };

const project = (name: string, include: string, exclude: string[], provide: Partial<ProvidedContext>) => ({
  extends: true as const,
  test: {
    name,
    include: [include],
    exclude,
    provide: { engines, ...provide },
    retry: ATTEMPTS_AGAIN[name as keyof typeof ATTEMPTS_AGAIN] ?? 0,
  },
});

/** `npm run test:engines`: each test runs in three browser engines, with a project for each. */
export default defineConfig({
  test: {
    environment: 'node',
    // A browser keeps one core busy, and the project targets machines with two.
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
