/**
 * Our simulator in WASM, native and in JavaScript, the memory pass, and two particle engines, for one number of
 * particles.
 */
import { demand, say } from '../support/figures.ts';
import { seededCloud } from './cloud.ts';
import { meanDistance, type Contestant } from './contestant.ts';
import { Memory, Native, NativeMemory } from './limits.ts';
import { Nebula } from './nebula.ts';
import { JavaScript, Wasm } from './ours.ts';
import { Quarks } from './quarks.ts';
import { interleave, type Costs, type Plan } from './rounds.ts';
import { largestDifference } from './twin.ts';

/** Positions in metres, and other values: single precision at 5 m over the compared steps. */
const TOLERANCE = 1e-4;
const COMPARED_STEPS = 20;
/** Largest factor between the mean distances moved of an engine and of our simulator, in this number of steps. */
const COMPARABLE = 2;
const DISTANCE_STEPS = 120;
const COMPARED_COUNT = 1000;

interface Field {
  wasm: Wasm;
  native: Native;
  javaScript: JavaScript;
  memory: Memory;
  engines: (Quarks | Nebula)[];
}

async function enter(count: number): Promise<Field> {
  await say(`${count} particles are made`);
  const wasm = await Wasm.create(count);
  const native = await Native.create(count, wasm.start);
  return {
    wasm,
    native,
    javaScript: new JavaScript(count),
    memory: await Memory.create(count),
    engines: enginesWith(count),
  };
}

/**
 * All costs for one number of particles, after a check that all contestants do the same work as far as they support it.
 */
export async function hold(count: number, plan: Plan): Promise<Costs> {
  const field = await enter(count);
  await compareOurs(field);
  const { wasm, native, javaScript, memory, engines } = field;
  const contestants: Contestant[] = [wasm, native, javaScript, memory, new NativeMemory(), ...engines];
  const before = engines.map((engine) => engine.places());
  const costs = await interleave(
    contestants,
    contestants.map(() => count),
    plan,
    `${count} particles`,
  );
  engines.forEach((engine, i) => {
    demand(engine.alive === count, `${engine.alive} of ${count} particles live in ${engine.name}`);
    demand(meanDistance(before[i], engine.places()) > 0, `nothing moves in ${engine.name}`);
  });
  demand(wasm.simulator.alive === count, `${wasm.simulator.alive} of ${count} particles live in ours`);
  contestants.forEach((contestant) => contestant.dispose());
  return costs;
}

/** WASM and native must be bit-identical, JavaScript equal up to rounding. */
async function compareOurs({ wasm, native, javaScript }: Field): Promise<void> {
  const start = wasm.particles();
  wasm.advance(COMPARED_STEPS);
  await native.advance(COMPARED_STEPS);
  javaScript.advance(COMPARED_STEPS);
  const [hash, nativeHash] = [wasm.simulator.hash(), await native.hash()];
  demand(hash === nativeHash, `the fingerprint is ${hash} in WASM and ${nativeHash} natively`);
  const end = wasm.particles();
  const difference = largestDifference(end, javaScript.particles);
  demand(difference < TOLERANCE, `WASM and JavaScript differ by ${difference}`);
  demand(javaScript.alive === end.x.length, 'different numbers of particles live in WASM and JavaScript');
  demand(largestDifference(end, start) > 0.1, 'nothing moves in ours');
}

/**
 * Engines with other equations of motion cannot reach the same positions, but the mean distance moved must be similar.
 *
 * @returns By engine name, the mean distance moved relative to ours.
 */
export async function compareEngines(): Promise<Record<string, number>> {
  const wasm = await Wasm.create(COMPARED_COUNT);
  const start = wasm.places();
  wasm.advance(DISTANCE_STEPS);
  const ours = meanDistance(start, wasm.places());
  wasm.dispose();
  const ways: Record<string, number> = {};
  for (const engine of enginesWith(COMPARED_COUNT)) {
    engine.advance(DISTANCE_STEPS);
    const way = meanDistance(start, engine.places()) / ours;
    engine.dispose();
    demand(Math.max(way, 1 / way) < COMPARABLE, `particles go ${way} times as far in ${engine.name}`);
    ways[engine.name] = way;
  }
  return ways;
}

function enginesWith(count: number): (Quarks | Nebula)[] {
  const cloud = seededCloud(count, 3);
  return [new Quarks(cloud), new Nebula(cloud)];
}
