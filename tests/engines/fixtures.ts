/** The `test` of the engine tests: with a browser of the project's engine, shared by all tests of a file. */
import { inject, test as base } from 'vitest';
import type { Driver } from './drivers/driver.ts';
import { start } from './engines.ts';

/** A module's functions as promises: arguments and results are serialized as JSON. */
export type InPage<Module> = {
  [Name in keyof Module]: Module[Name] extends (...given: infer Given) => infer Value
    ? (...given: Given) => Promise<Awaited<Value>>
    : never;
};

/** Imports a source module in a page without product code, by its path in the repository. */
export type Load = <Module>(path: `/${string}`) => Promise<InPage<Module>>;

export const engine = inject('engine');

/** Tests that have begun, to recognize a second attempt. */
const begun = new Set<string>();

export const test = base.extend<{ $test: { freshPage: void }; $file: { browser: Driver; load: Load } }>({
  browser: [
    // oxlint-disable-next-line no-empty-pattern -- what it needs is no fixture, and the runner reads the pattern
    async ({}, use) => {
      const browser = await start(engine);
      await use(browser);
      await browser.close();
    },
    { scope: 'file' },
  ],
  load: [
    async ({ browser }, use) => {
      await browser.open(blankPage());
      await use((path) => Promise.resolve(inPage(browser, path)));
    },
    { scope: 'file' },
  ],
  // The memory of the page's simulators can be damaged after a failed attempt.
  freshPage: [
    async ({ browser, task }, use) => {
      if (begun.has(task.id)) await browser.open(blankPage());
      begun.add(task.id);
      await use();
    },
    { auto: true },
  ],
});

export function blankPage(): string {
  return `${inject('sources')}/tests/support/blank.html`;
}

/** The module at this path on the page's origin. */
export function inPage<Module>(browser: Driver, path: string): InPage<Module> {
  return new Proxy({} as InPage<Module>, {
    get: (_, name) =>
      // An awaited module must not be thenable.
      name === 'then'
        ? undefined
        : (...given: unknown[]) =>
            browser.evaluate(
              `import(${JSON.stringify(path)}).then((module) => module.${String(name)}(...${JSON.stringify(given)}))`,
            ),
  });
}
