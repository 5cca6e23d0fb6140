import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { Simulator } from '../../src/sim/simulator.ts';
import type { SimulatorFactory } from '../../src/sim/load.ts';
import { loadVariant } from './simWasm.ts';

/** The scenario and the hashes that the native build comes to: tests/collide_fixture.rs of the crate reads them too. */
const fixture = readFileSync(new URL('../../sim-wasm/sim/tests/collide_fixture.txt', import.meta.url), 'utf8');
const KINDS = ['fixed', 'kinematic', 'dynamic'];

function lines(word: string): string[] {
  const found = fixture.split('\n').filter((line) => line.startsWith(word));
  return found.map((line) => line.slice(word.length).trim());
}

const STEPS = Number(lines('steps ')[0]);

function start(factory: SimulatorFactory): Simulator {
  const simulator = factory.create({ capacity: Number(lines('capacity ')[0]), seed: Number(lines('seed ')[0]) });
  const pairs = lines('set ').map((line) => line.split(' '));
  simulator.set(Object.fromEntries(pairs.map(([key, value]) => [key, Number(value)])));
  return simulator;
}

/** The numbers of the fixture are those of the boundary; here they become descriptions again. */
function addRigids(simulator: Simulator): void {
  for (const line of lines('rigid ')) {
    const [form, pose] = line.split(' | ');
    const [kind, shape, dimensions] = form.split(' ');
    const [x, y, z, ...rotation] = pose.split(' ').map(Number);
    const sizes = dimensions.split(',').map(Number);
    const shapes = [
      { type: 'ball', radius: sizes[0] },
      { type: 'cuboid', halfExtents: sizes },
      { type: 'capsule', halfHeight: sizes[0], radius: sizes[1] },
      { type: 'cylinder', halfHeight: sizes[0], radius: sizes[1] },
    ] as const;
    simulator.addRigid({
      kind: KINDS[Number(kind)] as 'fixed',
      shape: shapes[Number(shape)],
      position: [x, y, z],
      rotation,
      restitution: 0.1,
      friction: 0.3,
      density: 500,
    });
  }
}

describe('the hash of the same scenario', () => {
  it.each(['core', 'physics'] as const)('is the native one without rigids in %s', async (variant) => {
    const simulator = start(await loadVariant(variant));
    simulator.step(STEPS);
    expect(simulator.hash()).toBe(lines('hash without rigids')[0]);
    simulator.dispose();
  });

  it('is the native one with rigids', async () => {
    const factory = await loadVariant('physics');
    const simulator = start(factory);
    addRigids(simulator);
    for (let step = 0; step < STEPS; step++) {
      simulator.moveRigid(0, [-1 + step / 128, 0.75, 0]);
      simulator.step();
    }
    expect(simulator.hash()).toBe(lines('hash with rigids')[0]);
    simulator.dispose();
  });
});
