/**
 * Records the calls of simulators, for `sim-wasm/sim/examples/native_hashes.rs` to repeat. Format of a call: its name,
 * a byte with the number of arguments, and the arguments, each after a byte with its type. Little endian, lengths are
 * 32-bit.
 */
import { SimulatorFactory } from '../../../src/simulator/load.ts';

type Method = (...given: unknown[]) => unknown;

/** Calls without side effects. `hash` is recorded as well, because the native program prints the hash there. */
const READS: ReadonlySet<PropertyKey> = new Set(['save', 'arrange', 'control', 'parameterKeys', 'parameterValues']);

/** Calls of all simulators of its factories, in order. */
export class RecordedCalls {
  readonly #parts: Uint8Array[] = [];

  /** Returns a factory whose simulators record their calls here. */
  record({ module }: SimulatorFactory): SimulatorFactory {
    const { bindings, memory } = module;
    const Simulator = new Proxy(bindings.Simulator, {
      construct: (real, [capacity, seed]: [number, number]) => {
        this.#add('new', [capacity, seed]);
        return this.#watch(new real(capacity, seed));
      },
    });
    return new SimulatorFactory({ bindings: { ...bindings, Simulator }, memory });
  }

  bytes(): Uint8Array {
    return Buffer.concat(this.#parts);
  }

  #watch<Handle extends object>(handle: Handle): Handle {
    return new Proxy(handle, {
      get: (target, name) => {
        const value = Reflect.get(target, name) as unknown;
        if (typeof value !== 'function' || READS.has(name)) return bound(value, target);
        return (...given: unknown[]) => {
          this.#add(String(name), given);
          return (value as Method).apply(target, given);
        };
      },
    });
  }

  #add(name: string, given: unknown[]): void {
    this.#parts.push(sized(Buffer.from(name)), Uint8Array.of(given.length), ...given.flatMap(argument));
  }
}

function bound(value: unknown, target: object): unknown {
  return typeof value === 'function' ? (value as Method).bind(target) : value;
}

function argument(given: unknown): Uint8Array[] {
  if (typeof given === 'number') return [Uint8Array.of(0), bytesOf(Float64Array.of(given))];
  if (typeof given === 'string') return [Uint8Array.of(1), sized(Buffer.from(given))];
  if (given instanceof Float32Array) return [Uint8Array.of(2), sized(given)];
  if (given instanceof Float64Array) return [Uint8Array.of(3), sized(given)];
  if (given instanceof Uint32Array) return [Uint8Array.of(4), sized(given)];
  throw new TypeError(`A call with ${String(given)} cannot be recorded: add its type here and to native_hashes.rs.`);
}

/** Prefixed with the length in bytes. */
function sized(given: ArrayBufferView): Uint8Array {
  return Buffer.concat([bytesOf(Uint32Array.of(given.byteLength)), bytesOf(given)]);
}

/** A copy: callers may reuse an array. */
function bytesOf({ buffer, byteOffset, byteLength }: ArrayBufferView): Uint8Array {
  return new Uint8Array(buffer, byteOffset, byteLength).slice();
}
