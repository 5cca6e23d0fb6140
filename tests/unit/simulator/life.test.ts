import { afterEach, describe, expect, it, vi } from 'vitest';
import type { AssetUrls } from '../../../src/base/assetUrls.ts';
import { LoadError, ParameterError, SimulatorError, UnsupportedError } from '../../../src/base/errors.ts';
import { EVERYTHING } from '../../support/sim/everything.ts';
import { JET, loadVariant, wasmBytes } from '../../support/sim/simWasm.ts';

async function jet(capacity = 256) {
  const factory = await loadVariant('core');
  const simulator = factory.create({ capacity, seed: 3 });
  simulator.set(JET);
  return { factory, simulator };
}

function caught(action: () => unknown): Error {
  try {
    action();
  } catch (error) {
    return error as Error;
  }
  throw new Error('nothing was thrown');
}

describe('a simulator', () => {
  it('returns rows after memory has grown', async () => {
    const { factory, simulator } = await jet();
    simulator.step(30);
    const { rows: before } = simulator.arrange(EVERYTHING);
    const places = [...before.place];
    factory.module.memory.grow(20);
    expect(before.place.length, 'the old view has lost its buffer').toBe(0);
    const { rows: after } = simulator.arrange(EVERYTHING);
    expect(after.count).toBeGreaterThan(0);
    expect([...after.place]).toEqual(places);
    simulator.dispose();
  });

  it('allocates no memory while it runs', async () => {
    const { factory, simulator } = await jet(2000);
    simulator.step(200);
    simulator.arrange(EVERYTHING);
    const size = factory.module.memory.buffer.byteLength;
    for (let round = 0; round < 200; round++) {
      simulator.step(5);
      simulator.arrange(EVERYTHING);
    }
    expect(factory.module.memory.buffer.byteLength).toBe(size);
    simulator.dispose();
  });

  it('releases its memory', async () => {
    const { factory, simulator } = await jet(50_000);
    simulator.dispose();
    const size = factory.module.memory.buffer.byteLength;
    for (let round = 0; round < 50; round++) factory.create({ capacity: 50_000, seed: round }).dispose();
    expect(factory.module.memory.buffer.byteLength).toBe(size);
  });

  it('uses at most 112 bytes per particle', async () => {
    const factory = await loadVariant('core');
    const before = factory.module.memory.buffer.byteLength;
    const simulator = factory.create({ capacity: 1_000_000, seed: 1 });
    const bytes = (factory.module.memory.buffer.byteLength - before) / 1_000_000;
    expect(bytes).toBeGreaterThan(56);
    expect(bytes).toBeLessThanOrEqual(112);
    simulator.dispose();
  });

  it('rejects a number by its key and changes nothing', async () => {
    const { simulator } = await jet();
    simulator.step(10);
    const hash = simulator.hash();
    for (const value of [NaN, Infinity, -1, 1e9]) {
      const error = caught(() => simulator.set({ 'emission.lifetime': 2, 'emission.rate': value })) as ParameterError;
      expect(error).toBeInstanceOf(ParameterError);
      expect(error.key).toBe('emission.rate');
      expect(error.value).toBe(value);
      expect(error.message).toContain('a number from 0 to 20000');
    }
    expect(simulator.hash()).toBe(hash);
    const twin = (await jet()).simulator;
    twin.step(10);
    simulator.step(60);
    twin.step(60);
    expect(simulator.hash(), 'the lifetime beside a refused rate was not taken').toBe(twin.hash());
    simulator.dispose();
    twin.dispose();
  });

  it('rejects invalid numbers, keys, counts and capacities', async () => {
    const { factory, simulator } = await jet();
    const rejected: [() => unknown, string][] = [
      [() => simulator.set({ 'emission.rate': '5' as unknown as number }), 'emission.rate'],
      [() => simulator.set({ 'emission.colour': 5 }), 'emission.colour'],
      [() => simulator.set({ 'emitters.8.size': 0.1 }), 'emitters.8.size'],
      [() => simulator.step(-1), 'step count'],
      [() => simulator.step(0.5), 'step count'],
      [() => factory.create({ capacity: 0, seed: 1 }), 'simulation.maxParticles'],
      [() => factory.create({ capacity: NaN, seed: 1 }), 'simulation.maxParticles'],
      [() => factory.create({ capacity: 4_294_967_295, seed: 1 }), 'simulation.maxParticles'],
      [() => factory.create({ capacity: 10, seed: -1 }), 'seed'],
    ];
    for (const [action, word] of rejected) {
      const error = caught(action);
      expect(error, word).toBeInstanceOf(ParameterError);
      expect(error.message).toContain(word);
    }
    simulator.dispose();
  });

  it('rejects a view that contains NaN', async () => {
    const { simulator } = await jet();
    simulator.step(5);
    expect(caught(() => simulator.arrange({ ...EVERYTHING, blend: NaN }))).toBeInstanceOf(ParameterError);
    expect(simulator.arrange(EVERYTHING).rows.count).toBeGreaterThan(0);
    simulator.dispose();
  });

  it('continues from saved bytes to the same hash, and rejects damaged ones', async () => {
    const { factory, simulator } = await jet();
    simulator.step(50);
    const bytes = simulator.save();
    const other = factory.create({ capacity: 256, seed: 99 });
    other.restore(bytes);
    simulator.step(50);
    other.step(50);
    expect(other.hash()).toBe(simulator.hash());
    const damaged = bytes.slice();
    damaged[damaged.length >> 1] ^= 1;
    expect(caught(() => other.restore(damaged))).toBeInstanceOf(SimulatorError);
    expect(other.hash()).toBe(simulator.hash());
    simulator.dispose();
    other.dispose();
  });

  it('can be disposed twice and then reports it', async () => {
    const { simulator } = await jet();
    simulator.dispose();
    simulator.dispose();
    for (const action of [() => simulator.step(), () => simulator.alive, () => simulator.arrange(EVERYTHING)]) {
      expect(caught(action).message).toBe('The simulator was disposed. Create a new one.');
      expect(caught(action)).toBeInstanceOf(SimulatorError);
    }
  });

  it('stops after a fault, reports the reason, and does not affect other simulators', async () => {
    const { factory, simulator } = await jet();
    const other = factory.create({ capacity: 100, seed: 1 });
    const error = caught(() => simulator.provokeFault('a cosmic ray'));
    expect(error).toBeInstanceOf(SimulatorError);
    expect(error.message).toContain('a cosmic ray');
    expect(error.cause).toBeInstanceOf(WebAssembly.RuntimeError);
    expect(caught(() => simulator.step())).toBeInstanceOf(SimulatorError);
    expect(caught(() => simulator.hash()).message).toContain('has stopped after a fault');
    simulator.dispose();
    other.step(10);
    expect(other.steps).toBe(10);
    other.dispose();
  });

  it('returns the bounding box of living particles', async () => {
    const { simulator } = await jet();
    simulator.step(60);
    const { rows, bounds } = simulator.arrange(EVERYTHING);
    const { count, place } = rows;
    let top = -Infinity;
    for (let index = 0; index < count; index++) top = Math.max(top, place[4 * index + 1] + place[4 * index + 3]);
    expect(bounds.max[1]).toBeCloseTo(top, 4);
    simulator.dispose();
  });

  it('can get a larger capacity', async () => {
    const { simulator } = await jet(10);
    simulator.step(20);
    expect(simulator.alive).toBe(10);
    expect(simulator.waiting).toBeGreaterThan(0);
    simulator.resize(500);
    simulator.step(20);
    expect(simulator.alive).toBeGreaterThan(300);
    simulator.dispose();
  });
});

describe('loading', () => {
  afterEach(() => {
    vi.unstubAllGlobals();
    vi.resetModules();
  });

  /** A new module instance without loaded modules. */
  async function fresh() {
    vi.resetModules();
    Reflect.deleteProperty(globalThis, Symbol.for('cartoon-smoke.assetUrls'));
    return import('../../../src/simulator/load.ts');
  }

  function serve(bytes: Uint8Array<ArrayBuffer>, headers: Record<string, string> = {}) {
    const fetched = vi.fn(async () => new Response(bytes, { headers }));
    vi.stubGlobal('fetch', fetched);
    return fetched;
  }

  it('downloads once and reports progress to all callers', async () => {
    const bytes = wasmBytes('core');
    const fetched = serve(bytes, { 'content-length': String(bytes.length) });
    const { loadSimulators: load } = await fresh();
    const first = vi.fn();
    const second = vi.fn();
    const [a, b] = await Promise.all([
      load({ physics: false, onProgress: first }),
      load({ physics: false, onProgress: second }),
    ]);
    expect(a).toBe(b);
    expect(await load({ physics: false })).toBe(a);
    expect(fetched).toHaveBeenCalledTimes(1);
    expect(first).toHaveBeenLastCalledWith({ loaded: bytes.length, total: bytes.length });
    expect(second.mock.calls).toEqual(first.mock.calls);
  });

  it('ignores a Content-Length that the download exceeds', async () => {
    const bytes = wasmBytes('core');
    serve(bytes, { 'content-length': '1000' });
    const { loadSimulators: load } = await fresh();
    const onProgress = vi.fn();
    await load({ physics: false, onProgress });
    expect(onProgress).toHaveBeenLastCalledWith({ loaded: bytes.length, total: undefined });
  });

  it('reports a failure and retries on the next call', async () => {
    vi.stubGlobal('fetch', async () => new Response('no', { status: 404, statusText: 'Not Found' }));
    const { loadSimulators: load } = await fresh();
    const error = await load({ physics: false }).catch((reason: unknown) => reason as Error);
    expect((error as Error).name).toBe(new LoadError().name);
    expect((error as Error).message).toMatch(/core\/bindings_bg\.wasm: the server answered 404 Not Found/);
    serve(wasmBytes('core'));
    expect((await load({ physics: false })).create({ capacity: 1, seed: 0 }).alive).toBe(0);
  });

  it('names the remedy when a server answers with its page', async () => {
    vi.stubGlobal('fetch', async () => new Response('<!doctype html>', { headers: { 'content-type': 'text/html' } }));
    const { loadSimulators: load } = await fresh();
    const error = await load({ physics: true }).catch((reason: unknown) => reason as Error);
    expect((error as Error).name).toBe(new LoadError().name);
    expect((error as Error).message).toMatch(/physics\/bindings_bg\.wasm: .* HTML page .* setAssetUrls/);
  });

  it('loads from the URL that the page has set', async () => {
    const fetched = serve(wasmBytes('core'));
    const { loadSimulators: load } = await fresh();
    const { setAssetUrls } = await import('../../../src/base/setAssetUrls.ts');
    setAssetUrls({ core: 'https://cdn.example/core.wasm', physics: new URL('https://cdn.example/physics.wasm') });
    await load({ physics: false });
    expect(fetched).toHaveBeenCalledWith(new URL('https://cdn.example/core.wasm'), expect.anything());
    vi.stubGlobal('fetch', async () => new Response('', { status: 403 }));
    await expect(load({ physics: true })).rejects.toThrow('https://cdn.example/physics.wasm: the server answered 403');
  });

  it.each([
    [
      { simulator: 'https://cdn.example/core.wasm' },
      /^setAssetUrls\.simulator cannot .* core, meshes, physics, stageModel, worker/,
    ],
    [{ core: 'https://cdn.example/core.wasm', worker: 5 }, /^setAssetUrls\.worker cannot be 5: it takes a URL\.$/],
    [{ core: '' }, /^setAssetUrls\.core cannot be “”/],
    [{ core: 'http://[' }, /^setAssetUrls\.core cannot be “http:\/\/\[”/],
  ])('rejects the URLs %j and changes none', async (urls, message) => {
    const fetched = serve(wasmBytes('core'));
    const { loadSimulators: load } = await fresh();
    const { setAssetUrls } = await import('../../../src/base/setAssetUrls.ts');
    expect(() => setAssetUrls(urls as AssetUrls)).toThrow(message);
    await load({ physics: false });
    expect(String((fetched.mock.calls as unknown[][])[0][0])).toMatch(/wasm\/core\/bindings_bg\.wasm$/);
  });

  it('reports missing SIMD before it downloads anything', async () => {
    const fetched = serve(wasmBytes('core'));
    vi.stubGlobal('WebAssembly', { ...WebAssembly, validate: () => false });
    const { loadSimulators: load } = await fresh();
    const error = await load({ physics: false }).catch((reason: unknown) => reason as Error);
    expect((error as Error).name).toBe(new UnsupportedError().name);
    expect((error as Error).message).toContain('SIMD');
    expect(fetched).not.toHaveBeenCalled();
  });
});
