/** The simulator with measuring functions: `cargo xtask wasm --bench` in sim-wasm. */
import { SimulatorFactory } from '../../../../src/simulator/load.ts';
import type { Simulator } from '../../../../src/simulator/simulator.ts';
import { rigidArguments } from '../../../../src/simulator/rigidArguments.ts';
import type * as Bindings from '../../../../src/simulator/wasm/physics/bindings.js';

const FOLDER = '/sim-wasm/target/wasm/bench';

/** Additional functions of the measuring variant; sim-wasm/bindings/src/measure.rs. */
interface Measuring {
  stepObserved(): Float64Array;
  findInTouchedBoxes(): Uint32Array;
  projectionTime(asked: Uint32Array, limit: number): number;
  distances(asked: Uint32Array, limit: number): Float32Array;
}

/** Milliseconds of a step. */
export interface Parts {
  /** Rapier's own step. */
  world: number;
  /** All other costs of rigids: motion, grid, search, contacts. */
  collision: number;
}

/** A simulator that measures the parts of its steps. */
export class MeasuredSimulator {
  readonly simulator: Simulator;
  readonly rapier: Omit<Measuring, 'stepObserved'>;
  private readonly measuring: Measuring;

  constructor(simulator: Simulator, measuring: Measuring) {
    this.simulator = simulator;
    this.rapier = measuring;
    this.measuring = measuring;
  }

  step(): Parts {
    const [world, follow, , contacts] = this.measuring.stepObserved();
    return { world, collision: follow + contacts };
  }
}

/** Loads the module and returns a function that creates simulators. */
export async function loadMeasured(): Promise<(capacity: number) => MeasuredSimulator> {
  const bindings = (await import(/* @vite-ignore */ `${FOLDER}/bindings.js`)) as typeof Bindings;
  const bytes = await (await fetch(`${FOLDER}/bindings_bg.wasm`)).arrayBuffer();
  const { memory } = bindings.initSync({ module: await WebAssembly.compile(bytes) });
  let made: unknown;
  const Simulator = new Proxy(bindings.Simulator, {
    construct: (target, parameters: [number, number]) => {
      const handle = new target(...parameters);
      made = handle;
      return handle;
    },
  });
  const factory = new SimulatorFactory({ bindings: { ...bindings, Simulator, rigidArguments }, memory });
  return (capacity) => {
    const simulator = factory.create({ capacity, seed: 7 });
    return new MeasuredSimulator(simulator, made as Measuring);
  };
}
