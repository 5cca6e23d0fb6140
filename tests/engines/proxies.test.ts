/** Public objects work behind a Proxy, such as those of Vue. */
import { expect } from 'vitest';
import { test } from './fixtures.ts';

type Proxies = typeof import('../visual/proxies.cases.ts');

for (const name of ['ofSmoke', 'ofStage', 'ofRemote', 'ofElement'] as const)
  test(`${name}: members work behind a Proxy of each kind`, async ({ load }) => {
    const cases = await load<Proxies>('/tests/visual/proxies.cases.ts');
    const { none, ...others } = await cases[name]('main');
    expect(none).toMatch(/^\[/);
    for (const [kind, result] of Object.entries(others)) expect(result, kind).toBe(none);
  });
