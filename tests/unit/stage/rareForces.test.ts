/** Smoke that gets its first flow or shape in a core simulator is the same as that of a larger simulator from the start. */
import { afterAll, beforeAll, beforeEach, describe, expect, it } from 'vitest';
import type { Values } from '../../../src/parameters/parameter.ts';
import { defaults } from '../../../src/parameters/values.ts';
import { fetchTimelineText, loaded } from '../../../src/renderer/extraPasses.ts';
import { wisp } from '../../../src/scenes/wisp.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { hasRareForces } from '../../../src/simulator/rareForces.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const VALUES: Values = { ...defaults(), scene: 'wisp', 'simulation.maxParticles': 500 };
const FLOW: Values = { 'flows.0.speed': 2, 'flows.0.swirl': 3, 'flows.0.points': '0:.2:0,.4:.9:.1,-.3:1.6:-.2' };
const SHAPE: Values = {
  'shapes.0.outline': 'IBKiYqM3Owewd_uz8gxgxXxWxB-QuQuJ4WyeneZWOJIQSQSBCXPWPgPgPzE_Swjwi3yq0',
  'shapes.0.speed': 2,
};
const LANE = '120;flows.0.speed/0*0/60*3/100*1;burst/0*0*20';

const extras = loaded as { rareForces?: SimulatorFactory };
let core: SimulatorFactory;
let meshes: SimulatorFactory;
const before = extras.rareForces;

beforeAll(async () => {
  [core, meshes] = await Promise.all([loadVariant('core'), loadVariant('meshes')]);
  await fetchTimelineText({ timeline: LANE });
});
beforeEach(() => delete extras.rareForces);
afterAll(() => void (extras.rareForces = before));

const open = (factory: SimulatorFactory, values = VALUES) => new Simulation(factory, wisp(), values);

/** Advances until it waits, then loads what it lacks and goes on. */
function advance(simulation: Simulation, steps: number): void {
  const left = simulation.advance(steps);
  if (left === 0) return;
  expect(simulation.isWaiting).toBe(true);
  expect(simulation.advance(left), 'takes steps without the force').toBe(left);
  extras.rareForces = meshes;
  expect(simulation.advance(left)).toBe(0);
}

/** What happens at step 30 of 150, or from the start. */
const CASES: Record<string, { readonly start?: Values; readonly act: (simulation: Simulation) => void }> = {
  'a value': { act: (simulation) => simulation.set(FLOW) },
  'a value, and one that moves': {
    act: (simulation) => {
      simulation.input((simulator) => simulator.inputSteer(0, 1));
      simulation.set(FLOW);
      simulation.set({ 'flows.0.points': '0:.2:0,.4:.9:.1,-.3:1.6:-.25', 'emission.rate': 90 });
    },
  },
  'a shape': { act: (simulation) => simulation.set(SHAPE) },
  'a timeline': { act: (simulation) => simulation.play(LANE) },
  'a timeline from the start': { start: { ...VALUES, timeline: LANE }, act: () => undefined },
  'a saved state': {
    act: (simulation) => {
      const other = open(meshes, { ...VALUES, ...FLOW });
      other.advance(40);
      simulation.restore(other.save(VALUES), VALUES);
      other.dispose();
    },
  },
  'a take': {
    act: (simulation) => {
      const other = open(meshes);
      other.advance(20);
      other.set(FLOW);
      other.advance(20);
      simulation.playTake(other.take());
      other.dispose();
    },
  },
};

describe.each(Object.entries(CASES))('%s', (_, { start = VALUES, act }) => {
  function run(factory: SimulatorFactory): readonly unknown[] {
    const simulation = open(factory, start);
    advance(simulation, 30);
    act(simulation);
    advance(simulation, 120);
    const { simulator } = simulation;
    expect(simulator.hasRigids).toBe(true);
    const take = simulation.take();
    simulation.approach(10 + simulation.readTake(take).start);
    const early = simulator.hash();
    simulation.advance(20);
    const result = [simulator.steps, simulator.hash(), early, take, simulation.readTake(take).inputs];
    simulation.dispose();
    return result;
  }

  it('takes the first step with a flow in a larger simulator, as if it had been there from the start', () => {
    const expected = run(meshes);
    delete extras.rareForces;
    expect(run(core)).toEqual(expected);
  });
});

it('goes on without flows if their code cannot be loaded', () => {
  const simulation = open(core);
  simulation.set(FLOW);
  expect(simulation.advance(5)).toBe(5);
  simulation.goesWithoutForces = true;
  expect(simulation.advance(5)).toBe(0);
  simulation.dispose();
});

it('finds rare forces in keys and in timelines only', () => {
  expect(hasRareForces(VALUES)).toBe(false);
  expect(hasRareForces({ ...VALUES, 'vortices.0.circulation': 1, timeline: '60;emission.rate/0*1' })).toBe(false);
  expect(hasRareForces({ 'flows.3.speed': 0 })).toBe(true);
  expect(hasRareForces({ timeline: LANE })).toBe(true);
});
