import { readFileSync } from 'node:fs';
import { expect, test } from '../support/fixtures.ts';
import { linesOf } from '../support/hashFixture.ts';

type Load = typeof import('../../src/sim/load.ts');
type Fixture = typeof import('../support/hashFixture.ts');

const text = readFileSync(new URL('../../sim-wasm/sim/tests/collide_fixture.txt', import.meta.url), 'utf8');

test('the same seed has the same hash natively and in Chromium', async ({ load }) => {
  const simulators = await load<Load>('/src/sim/load.ts');
  const fixture = await load<Fixture>('/tests/support/hashFixture.ts');
  const hashes = await simulators.evaluate(
    async (module, [scenario, input]) => {
      const core = await module.loadSimulators({ physics: false });
      const physics = await module.loadSimulators({ physics: true });
      return [
        scenario.hashWithoutRigids(core, input),
        scenario.hashWithoutRigids(physics, input),
        scenario.hashWithRigids(physics, input),
      ];
    },
    [fixture, text] as const,
  );
  const without = linesOf(text, 'hash without rigids')[0];
  expect(hashes).toEqual([without, without, linesOf(text, 'hash with rigids')[0]]);
});
