/** Builds what pages are tested on before anybody opens one: workers that find it missing would all build it. */
import { test } from '@playwright/test';
import { script } from './server.ts';

interface Component {
  isFresh(): boolean;
  bring(say: () => void): Promise<void>;
}

for (const [what, path] of [
  ['site', 'setup/site.mjs'],
  ['package', 'setup/package.mjs'],
] as const) {
  test(`the ${what} is built from the sources that lie here`, async () => {
    const component = await script<Component>(path);
    if (!component.isFresh()) await component.bring(() => undefined);
    test.expect(component.isFresh()).toBe(true);
  });
}
