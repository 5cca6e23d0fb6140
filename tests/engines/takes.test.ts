/** Takes and saved states give the same hashes in this engine and in Node. */
import { expect } from 'vitest';
import { decode } from '../../src/parameters/codec.ts';
import type { Values } from '../../src/parameters/parameter.ts';
import { withDrops } from '../../src/scenes/drops.ts';
import { sceneNamed } from '../../src/scenes/scenes.ts';
import { Simulation } from '../../src/stage/simulation.ts';
import { loadVariant } from '../support/sim/simWasm.ts';
import { test } from './fixtures.ts';

type Stages = typeof import('./page/stages.ts');
type Element = typeof import('./page/element.ts');

/** Drags the ball and drops an object in the lamp; steers the airplane. */
test.for(['lamp', 'airplane'] as const)('a take of the %s replays from its link', async (preset, { load }) => {
  const stages = await load<Stages>('/tests/engines/page/stages.ts');
  const { hash, link, steps, inputs } = await stages.perform(preset);
  expect(inputs).toBeGreaterThan(9);
  const element = await load<Element>('/tests/engines/page/element.ts');
  expect(await element.hashAtLink(link)).toEqual({ hash, notices: [] });
  expect(await hashInNode(preset, link, steps)).toBe(hash);
});

test('a saved state continues in another stage, and in Node', async ({ load }) => {
  const stages = await load<Stages>('/tests/engines/page/stages.ts');
  const { state, values, saved, restored, ends } = await stages.saveAndRestore('lamp', 60);
  expect(restored).toBe(saved);
  expect(ends[1]).toBe(ends[0]);
  const simulation = await simulationOf('lamp', values);
  simulation.restore(Buffer.from(state, 'base64'), values);
  simulation.advance(60);
  expect(simulation.simulator.hash()).toBe(ends[0]);
});

async function hashInNode(preset: string, link: string, steps: number): Promise<string> {
  const { state, take } = await decode(link);
  const simulation = await simulationOf(preset, state.values);
  simulation.replay(take!, state.values);
  simulation.advance(steps);
  return simulation.simulator.hash();
}

async function simulationOf(scene: string, values: Values): Promise<Simulation> {
  return new Simulation(await loadVariant('physics'), withDrops(await sceneNamed(scene).load()), values, 0);
}
