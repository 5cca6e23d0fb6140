/** Hours of smoke under every force: no step fails, and memory does not grow. */
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { expect, it } from 'vitest';
import { listNames } from '../../../src/parameters/lists.ts';
import { defaultPreset, presetValues } from '../../../src/parameters/presets.ts';
import { startValues } from '../../../src/parameters/words/lists.ts';
import { lamp } from '../../../src/scenes/lamp.ts';
import { simulatorValues } from '../../../src/simulator/simulatorValues.ts';
import { EVERYTHING } from '../../support/sim/everything.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const STEPS = 1_000_000;
const SAMPLES = 200;
/** Samples until all one-time allocations are done. */
const WARM_UP = 40;
/**
 * The heap differs by some ten thousand bytes between collections; a leak of one byte per step would exceed this limit.
 */
const HEAP_SLACK = 400_000;

const forces: Record<string, number> = Object.assign(
  {},
  ...listNames
    .filter((list) => list !== 'emitters' && list !== 'colliders')
    .map((list) => simulatorValues(startValues(list, 1))),
);

it(`smokes for ${STEPS} steps with constant memory and valid positions`, { timeout: 1_500_000 }, async () => {
  const factory = await loadVariant('physics');
  const simulator = factory.create({ capacity: 1000, seed: 11 });
  const scene = lamp();
  simulator.set({ ...scene.rig, ...simulatorValues(presetValues(defaultPreset)), ...forces, 'emission.rate': 400 });
  // Only the ball and the table: the lamp's many parts would take most of the time.
  for (const rigid of scene.rigids.slice(0, 2)) simulator.addRigid(rigid);
  const collectGarbage = garbageCollector();
  const pages = new Set<number>();
  const heaps: number[] = [];
  for (let sample = 0; sample < SAMPLES; ++sample) {
    simulator.moveRigid(scene.handle!.rigid, [Math.sin(sample), 1.2 + Math.sin(0.7 * sample), Math.cos(1.3 * sample)]);
    simulator.step(STEPS / SAMPLES);
    const { count, place } = simulator.arrange(EVERYTHING).rows;
    expect(count).toBeGreaterThan(900);
    expect(place.every((value) => Math.abs(value) < 10_000)).toBe(true);
    collectGarbage();
    if (sample < WARM_UP) continue;
    pages.add(factory.module.memory.buffer.byteLength);
    heaps.push(process.memoryUsage().heapUsed);
  }
  expect(simulator.steps).toBe(STEPS);
  expect(pages.size, 'sizes of the memory of WASM').toBe(1);
  const late = heaps.slice(-WARM_UP);
  expect(Math.min(...late) - Math.min(...heaps.slice(0, WARM_UP)), 'growth of the heap').toBeLessThan(HEAP_SLACK);
});

/** Node exposes it only with a flag. */
function garbageCollector(): () => void {
  setFlagsFromString('--expose-gc');
  return runInNewContext('gc') as () => void;
}
