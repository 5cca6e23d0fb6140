import { expect, longIf, test } from '../support/fixtures.ts';

type Proxies = typeof import('./proxies.cases.ts');

for (const name of ['ofSmoke', 'ofStage', 'ofRemote', 'ofElement'] as const)
  test(`${name}: members work behind a Proxy of each kind${longIf(/Remote|Element/.test(name))}`, async ({ load }) => {
    const cases = await load<Proxies>('/tests/visual/proxies.cases.ts');
    const results = [await cases.evaluate((module, called) => module[called]('main'), name)];
    if (name === 'ofRemote') results.push(await cases.evaluate((module) => module.ofRemote('worker')));
    for (const { none, ...others } of results) {
      expect(none).toMatch(/^\[/);
      for (const [kind, result] of Object.entries(others)) expect(result, kind).toBe(none);
    }
  });
