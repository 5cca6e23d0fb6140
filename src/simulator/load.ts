/** Fetches and instantiates the simulator's WASM module, once per variant, and creates simulators from it. */
import { assetUrl, servedUrl } from '../base/assetUrls.ts';
import { LoadError, UnsupportedError } from '../base/errors.ts';
import { inTime, whenLate } from '../base/timeout.ts';
import type { TakeInfo } from './input.ts';
import { errorOfSimulator, isSimulatorRejection } from './simulatorError.ts';
import { Simulator, type SimulatorBindings, type SimulatorModule, type SimulatorOptions } from './simulator.ts';

/** Download progress in bytes after decompression. `total` is undefined if the server does not report it. */
export interface LoadProgress {
  loaded: number;
  total: number | undefined;
}

/** The code and the WASM of one build of the simulator. */
export interface Variant {
  readonly name: 'core' | 'meshes' | 'physics';
  readonly code: () => Promise<SimulatorBindings>;
  /** Each URL is a literal, because bundlers only detect `new URL()` with a string literal. */
  readonly address: () => URL;
}

export interface LoadOptions {
  /** Whether to load the larger variant with rigid bodies, or another one. In the smaller one, `addRigid` throws. */
  physics: boolean | Variant;
  /** Called for each received chunk, also when another call started the download. */
  onProgress?: (progress: LoadProgress) => void;
  /** The WASM module, for environments that cannot fetch it. Ignored if another call already started the loading. */
  bytes?: BufferSource;
}

/** Creates simulators. All simulators of a factory share one WASM memory. */
export class SimulatorFactory {
  /** The instantiated module. For tests and benchmarks. */
  readonly module: SimulatorModule;

  constructor(module: SimulatorModule) {
    this.module = module;
  }

  /** @throws ParameterError if the capacity or the seed is out of range. */
  create(options: SimulatorOptions): Simulator {
    return new Simulator(this.module, options);
  }

  /** @throws SimulatorError if the bytes are not a take or are damaged. */
  readTake(bytes: Uint8Array): TakeInfo {
    try {
      return this.module.bindings.readTake(bytes) as TakeInfo;
    } catch (error) {
      throw isSimulatorRejection(error) ? errorOfSimulator(error) : error;
    }
  }
}

type Listener = (progress: LoadProgress) => void;

class Loading {
  readonly listeners = new Set<Listener>();
  readonly factory: Promise<SimulatorFactory>;

  constructor(variant: Variant, bytes: BufferSource | undefined) {
    this.factory = load(variant, bytes, (progress) => {
      for (const listener of this.listeners) listener(progress);
    });
  }
}

const CORE: Variant = {
  name: 'core',
  code: () => import('./core.ts'),
  address: () => new URL('./wasm/core/bindings_bg.wasm', import.meta.url),
};
const PHYSICS: Variant = {
  name: 'physics',
  code: () => import('./physics.ts'),
  address: () => new URL('./wasm/physics/bindings_bg.wasm', import.meta.url),
};

const loadings = new Map<Variant, Loading>();

/** Returns the WASM bytes of a variant. */
export type WasmSource = (variant: Variant) => Promise<BufferSource>;

let wasmSource: WasmSource | undefined;

/** Overrides where this page gets its WASM from. Applies to loads that start after the call. */
export function setWasmSource(source: WasmSource): void {
  wasmSource = source;
}

/**
 * Loads a variant of the simulator, or returns the one already loaded. After a failure the next call retries.
 *
 * @throws UnsupportedError without WASM SIMD. LoadError if the module cannot be fetched or compiled.
 */
export async function loadSimulators(options: LoadOptions): Promise<SimulatorFactory> {
  requireSimd();
  const { physics, onProgress } = options;
  const variant = typeof physics === 'object' ? physics : physics ? PHYSICS : CORE;
  let loading = loadings.get(variant);
  if (loading === undefined) {
    loading = new Loading(variant, options.bytes);
    loadings.set(variant, loading);
  }
  if (onProgress !== undefined) loading.listeners.add(onProgress);
  try {
    return await loading.factory;
  } catch (error) {
    if (loadings.get(variant) === loading) loadings.delete(variant);
    throw error;
  } finally {
    if (onProgress !== undefined) loading.listeners.delete(onProgress);
  }
}

/** The smallest WASM module with a SIMD instruction: a function that splats a constant. */
const SIMD_PROBE = Uint8Array.of(
  0,
  97,
  115,
  109,
  1,
  0,
  0,
  0,
  1,
  5,
  1,
  96,
  0,
  1,
  123,
  3,
  2,
  1,
  0,
  10,
  10,
  1,
  8,
  0,
  65,
  0,
  253,
  15,
  253,
  98,
  11,
);

function requireSimd(): void {
  if (typeof WebAssembly === 'object' && WebAssembly.validate(SIMD_PROBE)) return;
  throw new UnsupportedError('Smoke needs WebAssembly with SIMD. Use a current Firefox, Chrome, Edge or Safari.');
}

async function load(variant: Variant, given: BufferSource | undefined, report: Listener): Promise<SimulatorFactory> {
  try {
    const [bindings, module] = await Promise.all([inTime(variant.code()), compile(variant, given, report)]);
    const { memory } = bindings.initSync({ module });
    return new SimulatorFactory({ bindings, memory });
  } catch (error) {
    const place = wasmSource ? 'a custom source' : wasmAddress(variant).href;
    const reason = error instanceof Error ? error.message : String(error);
    throw new LoadError(`The simulator could not be loaded from ${place}: ${reason}`, { cause: error });
  }
}

async function compile(
  variant: Variant,
  given: BufferSource | undefined,
  report: Listener,
): Promise<WebAssembly.Module> {
  const bytes = given ?? (wasmSource && (await inTime(wasmSource(variant))));
  return bytes ? WebAssembly.compile(bytes) : compileFrom(wasmAddress(variant), report);
}

function wasmAddress({ name, address }: Variant): URL {
  const own = assetUrl(name);
  if (own) return new URL(own);
  const url = address();
  // Turbopack's URLs have no origin, so they are kept as they are.
  const served = servedUrl(url.href);
  return served === url.href ? url : new URL(served);
}

async function compileFrom(address: URL, report: Listener): Promise<WebAssembly.Module> {
  const control = new AbortController();
  const giveUp = (error: Error) => control.abort(error);
  let stopWaiting: (() => void) | undefined = whenLate(giveUp);
  const stop = () => {
    stopWaiting?.();
    stopWaiting = undefined;
  };
  const hear = (progress: LoadProgress) => {
    report(progress);
    // Progress may still arrive after the compilation: it must not restart the timeout.
    if (!stopWaiting) return;
    stop();
    stopWaiting = whenLate(giveUp);
  };
  try {
    return await compileAnswer(await fetch(address, { signal: control.signal }), hear);
  } finally {
    stop();
  }
}

const HTML =
  'the server answered with an HTML page instead of WebAssembly. Serve the file, or set its URL with setAssetUrls (docs/three.md#asset-urls)';

/** Uses streaming compilation if the server sends the type `application/wasm`, which browsers require for it. */
async function compileAnswer(response: Response, report: Listener): Promise<WebAssembly.Module> {
  if (!response.ok) throw new Error(`the server answered ${response.status} ${response.statusText}`.trim());
  if (response.headers.get('content-type')?.startsWith('text/html')) throw new Error(HTML);
  // The compiler reports an interrupted download.
  reportProgress(response.clone(), report).catch(() => undefined);
  if (response.headers.get('content-type')?.startsWith('application/wasm')) {
    return WebAssembly.compileStreaming(response);
  }
  return WebAssembly.compile(await response.arrayBuffer());
}

async function reportProgress({ body, headers }: Response, report: Listener): Promise<void> {
  if (body === null) return;
  const stated = Number(headers.get('content-length')) || undefined;
  let loaded = 0;
  const reader = body.getReader();
  for (let piece = await reader.read(); !piece.done; piece = await reader.read()) {
    loaded += piece.value.length;
    // Content-Length counts compressed bytes, so it is no total once it is exceeded.
    report({ loaded, total: stated !== undefined && loaded <= stated ? stated : undefined });
  }
}
