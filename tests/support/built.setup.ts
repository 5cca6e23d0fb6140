/** Builds the site and the package before the first test, so that parallel workers do not each build them. */
import { test } from '@playwright/test';
import { script } from './server.ts';

interface Component {
  isFresh(): boolean;
  bring(say: () => void): Promise<void>;
}

test.describe.configure({ mode: 'parallel' });

for (const [what, path] of [
  ['site', 'setup/site.mjs'],
  ['package', 'setup/package.mjs'],
] as const) {
  test(`the ${what} is built from the current sources`, async () => {
    const component = await script<Component>(path);
    if (!component.isFresh()) await component.bring(() => undefined);
    test.expect(component.isFresh()).toBe(true);
  });
}
