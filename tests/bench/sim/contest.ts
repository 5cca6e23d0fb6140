/** Our simulator in WASM and native, the memory pass, and three.quarks, for one number of particles. */
import { demand, say } from '../support/figures.ts';
import { seededCloud } from './cloud.ts';
import { meanDistance, type Contestant } from './contestant.ts';
import { Memory, Native, NativeMemory } from './limits.ts';
import { Wasm } from './ours.ts';
import { Quarks } from './quarks.ts';
import { interleave, type Costs, type Plan } from './rounds.ts';

const COMPARED_STEPS = 20;
/** Largest factor between the mean distances moved of three.quarks and of our simulator, in this number of steps. */
const COMPARABLE = 2;
const DISTANCE_STEPS = 120;
const COMPARED_COUNT = 1000;

interface Field {
  wasm: Wasm;
  native: Native;
  memory: Memory;
  quarks: Quarks;
}

async function enter(count: number): Promise<Field> {
  await say(`${count} particles are made`);
  const wasm = await Wasm.create(count);
  const native = await Native.create(count, wasm.start);
  return { wasm, native, memory: await Memory.create(count), quarks: quarksWith(count) };
}

/**
 * All costs for one number of particles, after a check that all contestants do the same work as far as they support it.
 */
export async function hold(count: number, plan: Plan): Promise<Costs> {
  const field = await enter(count);
  await compareOurs(field);
  const { wasm, native, memory, quarks } = field;
  const contestants: Contestant[] = [wasm, native, memory, new NativeMemory(), quarks];
  const before = quarks.places();
  const costs = await interleave(
    contestants,
    contestants.map(() => count),
    plan,
    `${count} particles`,
  );
  demand(quarks.alive === count, `${quarks.alive} of ${count} particles live in three.quarks`);
  demand(meanDistance(before, quarks.places()) > 0, 'nothing moves in three.quarks');
  demand(wasm.simulator.alive === count, `${wasm.simulator.alive} of ${count} particles live in ours`);
  contestants.forEach((contestant) => contestant.dispose());
  return costs;
}

/** WASM and native must be bit-identical. */
async function compareOurs({ wasm, native }: Field): Promise<void> {
  const start = wasm.places();
  wasm.advance(COMPARED_STEPS);
  await native.advance(COMPARED_STEPS);
  const [hash, nativeHash] = [wasm.simulator.hash(), await native.hash()];
  demand(hash === nativeHash, `the fingerprint is ${hash} in WASM and ${nativeHash} natively`);
  demand(meanDistance(start, wasm.places()) > 0, 'nothing moves in ours');
}

/**
 * The mean distance moved in three.quarks, relative to ours. It must be similar: other equations of motion cannot reach
 * the same positions.
 */
export async function compareQuarks(): Promise<number> {
  const wasm = await Wasm.create(COMPARED_COUNT);
  const start = wasm.places();
  wasm.advance(DISTANCE_STEPS);
  const ours = meanDistance(start, wasm.places());
  wasm.dispose();
  const quarks = quarksWith(COMPARED_COUNT);
  quarks.advance(DISTANCE_STEPS);
  const way = meanDistance(start, quarks.places()) / ours;
  quarks.dispose();
  demand(Math.max(way, 1 / way) < COMPARABLE, `particles go ${way} times as far in three.quarks`);
  return way;
}

function quarksWith(count: number): Quarks {
  return new Quarks(seededCloud(count, 3));
}
