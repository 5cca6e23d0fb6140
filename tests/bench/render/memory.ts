/** memory.*: bytes per particle, and no allocation by step and arrange. */
import { loadSimulators, SimulatorFactory } from '../../../src/simulator/load.ts';
import type { Simulator, SimulatorModule } from '../../../src/simulator/simulator.ts';
import { rigidArguments } from '../../../src/simulator/rigidArguments.ts';
import type { View } from '../../../src/simulator/view.ts';
import { demand, figure, say, type Figure } from '../support/figures.ts';
import { poseAt, seededSwings } from '../sim/collide/obstacles.ts';

const CAPACITY_STEP = 100_000;
const CAPACITIES = 6;
const ROUNDS = 5;
const STEPS = 400;
/** Few enough that no garbage collection occurs. */
const UNCOLLECTED_STEPS = 100;

const VIEW: Omit<View, 'purpose'> = {
  blend: 0.5,
  cull: true,
  pad: 0.001,
  clipFromWorld: [0.3, 0, 0, 0, 0, 0.3, 0, 0, 0, 0, -0.05, 0, 0, 0, 0, 1],
  direction: [0, 0, -1],
  reach: 1.3,
  receivers: { min: [-3, 0, -3], max: [3, 5, 3] },
};
const VIEWS: readonly View[] = [
  { ...VIEW, purpose: 'eye' },
  { ...VIEW, purpose: 'light' },
];

/** A fountain at its maximum number of particles, with spawns, expiry and all forces. */
const FOUNTAIN = {
  'emission.rate': 4000,
  'emission.lifetime': 2,
  'emitters.0.speed': 3,
  'emitters.0.share': 1,
  'emitters.0.position.y': -1,
  'emission.growthTime': 0,
  'turbulence.speed': 0.5,
  'turbulence.octaves': 1,
  'vortices.0.circulation': 2,
};

export async function measureMemory(): Promise<Figure[]> {
  await say('memory.wasm');
  return [await bytesOfParticle(), ...(await perStep())];
}

/** Each capacity in a separate WASM memory: in a shared one the next simulator would reuse freed memory. */
async function bytesOfParticle(): Promise<Figure> {
  const sizes: number[] = [];
  for (let number = 1; number <= CAPACITIES; number++) {
    const factory = await freshFactory(number);
    const simulator = factory.create({ capacity: number * CAPACITY_STEP, seed: 1 });
    simulator.set(FOUNTAIN);
    simulator.step(2);
    for (const view of VIEWS) simulator.arrange(view);
    sizes.push(factory.module.memory.buffer.byteLength);
  }
  const rounds = sizes.slice(1).map((bytes, index) => (bytes - sizes[index]) / CAPACITY_STEP);
  const note = `WASM memory of one capacity less that of ${CAPACITY_STEP} fewer, stepped and arranged; target <= 96`;
  return figure('memory.wasm', 'B', rounds, note);
}

/** A separate module instance: browsers treat another query as another module. */
async function freshFactory(number: number): Promise<SimulatorFactory> {
  const folder = '/src/simulator/wasm/physics';
  const [bindings, response] = await Promise.all([
    import(/* @vite-ignore */ `${folder}/bindings.js?copy=${number}`) as Promise<SimulatorModule['bindings']>,
    fetch(`${folder}/bindings_bg.wasm`),
  ]);
  const { memory } = bindings.initSync({ module: await WebAssembly.compile(await response.arrayBuffer()) });
  return new SimulatorFactory({ bindings: { ...bindings, rigidArguments }, memory });
}

async function perStep(): Promise<Figure[]> {
  await say('memory.perStep');
  const factory = await loadSimulators({ physics: true });
  const { simulator, swing } = makeBusy(factory);
  const advance = () => {
    swing();
    simulator.step();
    for (const view of VIEWS) simulator.arrange(view);
  };
  for (let step = 0; step < 400; step++) advance();
  demand(simulator.waiting > 0, 'the simulator is not full');
  const memory = factory.module.memory.buffer.byteLength;
  const kept = Array.from({ length: ROUNDS }, () => heapGrowth(STEPS, advance));
  const grown = factory.module.memory.buffer.byteLength - memory;
  const garbage = heapGrowth(UNCOLLECTED_STEPS, () => simulator.step(), false);
  const arranging = heapGrowth(UNCOLLECTED_STEPS, () => simulator.arrange(VIEWS[0]), false);
  simulator.dispose();
  const all = ROUNDS * STEPS;
  const work = 'births, deaths, 100 rigids moved, arranged for eye and light';
  return [
    figure('memory.perStep.wasm', 'B', [grown / all], `growth of WASM memory over ${all} steps; ${work}; target 0`),
    figure(
      'memory.perStep.heap',
      'B',
      kept,
      `growth of the JavaScript heap, collected, over ${STEPS} steps a round; the same work; target 0`,
    ),
    figure('memory.garbage.step', 'B', [garbage], 'what step() leaves for the collector; information'),
    figure('memory.garbage.arrange', 'B', [arranging], 'what arrange() leaves for the collector; information'),
  ];
}

/** A full simulator with moving rigids. */
function makeBusy(factory: SimulatorFactory): { simulator: Simulator; swing: () => void } {
  const simulator = factory.create({ capacity: 6000, seed: 1 });
  simulator.set(FOUNTAIN);
  const swings = seededSwings(11);
  for (const one of swings) simulator.addRigid({ kind: 'kinematic', shape: one.shape, ...poseAt(one, 0) });
  let steps = 0;
  const swing = () => {
    steps++;
    swings.forEach((one, index) => {
      const { position, rotation } = poseAt(one, steps / 60);
      simulator.moveRigid(index, position, rotation);
    });
  };
  return { simulator, swing };
}

/** Bytes by which the heap grows each time, with garbage collection before, and after by default. */
function heapGrowth(times: number, work: () => void, collected = true): number {
  // Twice, because finalizers of the first collection create garbage for the second.
  const settle = () => [collect(), collect()];
  work();
  settle();
  const before = heapSize();
  for (let number = 0; number < times; number++) work();
  if (collected) settle();
  return (heapSize() - before) / times;
}

function collect(): void {
  if (typeof globalThis.gc !== 'function') throw new Error('This browser does not let its garbage be collected.');
  globalThis.gc();
}

function heapSize(): number {
  const { memory } = performance as Performance & { memory?: { usedJSHeapSize: number } };
  if (!memory) throw new Error('This browser does not tell the size of its heap.');
  return memory.usedJSHeapSize;
}
