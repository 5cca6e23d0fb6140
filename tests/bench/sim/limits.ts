/** The same crate as native code, and the memory pass in both: lower bounds for a step in WASM. */
import { time } from '../support/figures.ts';
import type { Contestant } from './contestant.ts';

/** Sends a line to the native program (tests/bench/sim/native.mjs) and returns its response. */
async function order(line: string, body?: Uint8Array<ArrayBuffer>): Promise<string> {
  const response = await fetch(`/native?${encodeURIComponent(line)}`, { method: 'POST', body });
  if (!response.ok) throw new Error(`The native program gave no answer to ${line}.`);
  return response.text();
}

/** The native simulator. There is a single one, with the most recently loaded state. */
export class Native implements Contestant {
  readonly name = 'native';

  /** @param start A saved state with `count` particles. */
  static async create(count: number, start: Uint8Array): Promise<Native> {
    const loaded = await order(`load ${count} ${start.length}`, new Uint8Array(start));
    if (loaded !== 'loaded') throw new Error(`The native program answered ${loaded}.`);
    return new Native();
  }

  async restart(): Promise<void> {
    await order('restart');
  }

  async advance(steps: number): Promise<number> {
    return Number(await order(`step ${steps}`));
  }

  hash(): Promise<string> {
    return order('hash');
  }

  dispose(): void {}
}

/** The memory pass of the native program, for the number of particles that it has loaded. */
export class NativeMemory implements Contestant {
  readonly name = 'nativeMemory';

  restart(): void {}

  async advance(steps: number): Promise<number> {
    return Number(await order(`memory ${steps}`));
  }

  dispose(): void {}
}

interface PassModule {
  prepare(count: number): void;
  pass(count: number): number;
}

/** The memory pass in WASM: sim-wasm/sim/examples/memory. */
export class Memory implements Contestant {
  readonly name = 'memory';
  private readonly module: PassModule;

  private constructor(module: PassModule) {
    this.module = module;
  }

  static async create(count: number): Promise<Memory> {
    const bytes = await (await fetch('/sim-wasm/target/bench/memory.wasm')).arrayBuffer();
    const { instance } = await WebAssembly.instantiate(bytes);
    const module = instance.exports as unknown as PassModule;
    module.prepare(count);
    return new Memory(module);
  }

  restart(): void {}

  advance(steps: number): number {
    return time(() => this.module.pass(steps));
  }

  dispose(): void {
    this.module.prepare(0);
  }
}
