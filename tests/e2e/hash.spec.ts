import { readFileSync } from 'node:fs';
import { expect, test } from '../support/fixtures.ts';
import { linesOf } from '../support/sim/hashFixture.ts';
import { nativeTakes } from '../support/sim/nativeTakes.ts';

type Load = typeof import('../../src/simulator/load.ts');
type Meshes = typeof import('../../src/simulator/meshes.ts');
type Fixture = typeof import('../support/sim/hashFixture.ts');

const text = readFileSync(new URL('../../sim-wasm/sim/tests/collide_fixture.txt', import.meta.url), 'utf8');

test('the same seed has the same hash natively and in Chromium', async ({ load }) => {
  const simulators = await load<Load>('/src/simulator/load.ts');
  const fixture = await load<Fixture>('/tests/support/sim/hashFixture.ts');
  const variantOfMeshes = await load<Meshes>('/src/simulator/meshes.ts');
  const hashes = await simulators.evaluate(
    async (module, [scenario, variants, input]) => {
      const core = await module.loadSimulators({ physics: false });
      const physics = await module.loadSimulators({ physics: true });
      const meshes = await module.loadSimulators({ physics: variants.MESHES });
      return [
        scenario.hashWithoutRigids(core, input),
        scenario.hashWithoutRigids(physics, input),
        scenario.hashWithRigids(physics, input),
        scenario.hashWithColliders(core, input),
        scenario.hashWithMeshes(meshes, input),
      ];
    },
    [fixture, variantOfMeshes, text] as const,
  );
  const [without, ...others] = ['without rigids', 'with rigids', 'with colliders', 'with meshes'].map(
    (which) => linesOf(text, `hash ${which}`)[0],
  );
  expect(hashes).toEqual([without, without, ...others]);
});

test('takes over the whole parameter table have the same hashes natively and in Chromium @long', async ({ load }) => {
  test.setTimeout(1_200_000);
  const takes = await nativeTakes();
  expect(takes.length).toBe(40);
  expect(takes.filter(({ hasRigids }) => hasRigids).length).toBe(20);
  expect(takes.filter(({ alive }) => alive > 50).length, 'takes with smoke in them').toBeGreaterThan(30);
  const simulators = await load<Load>('/src/simulator/load.ts');
  const variantOfMeshes = await load<Meshes>('/src/simulator/meshes.ts');
  const found = await simulators.evaluate(
    async (module, [list, { MESHES }]) => {
      const [core, meshes, physics] = await Promise.all(
        [false, MESHES, true].map((variant) => module.loadSimulators({ physics: variant })),
      );
      const hashWith = (factory: typeof core, { steps, take }: (typeof list)[number]) => {
        const simulator = factory.create({ capacity: 1, seed: 0 });
        simulator.replay(Uint8Array.from(take.match(/../g)!, (digits) => parseInt(digits, 16)));
        while (simulator.steps < steps && !simulator.lacksForces) simulator.step();
        const hash = simulator.lacksForces ? undefined : simulator.hash();
        simulator.dispose();
        return hash;
      };
      return list.map((take) => {
        if (take.hasRigids) return { variant: 'physics', hash: hashWith(physics, take) };
        const hash = hashWith(core, take);
        return hash ? { variant: 'core', hash } : { variant: 'meshes', hash: hashWith(meshes, take) };
      });
    },
    [takes, variantOfMeshes] as const,
  );
  expect(found.map(({ hash }) => hash)).toEqual(takes.map(({ hash }) => hash));
  for (const variant of ['core', 'meshes'])
    expect(found.filter((one) => one.variant === variant).length, variant).toBeGreaterThan(3);
});
