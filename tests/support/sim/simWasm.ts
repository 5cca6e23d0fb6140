import { readFileSync } from 'node:fs';
import { loadSimulators, type SimulatorFactory, type Variant } from '../../../src/simulator/load.ts';
import { MESHES } from '../../../src/simulator/meshes.ts';

/** The built WASM of a variant. Node cannot fetch a file. */
export function wasmBytes(variant: Variant['name']): Buffer<ArrayBuffer> {
  return readFileSync(new URL(`../../../src/simulator/wasm/${variant}/bindings_bg.wasm`, import.meta.url));
}

export function loadVariant(variant: Variant['name']): Promise<SimulatorFactory> {
  const physics = variant === 'meshes' ? MESHES : variant === 'physics';
  return loadSimulators({ physics, bytes: wasmBytes(variant) });
}

/** An upward jet in air without turbulence. */
export const JET: Record<string, number> = {
  'emission.rate': 600,
  'emission.lifetime': 4,
  'emission.growthTime': 0,
  'turbulence.speed': 0,
  'emitters.0.share': 1,
  'emitters.0.direction.y': 1,
  'emitters.0.speed': 2,
  'emitters.0.spread': 0.3,
  'emitters.0.size': 0.1,
};
