/** The variant with meshes that move as they are told and with rare forces, in a module that few pages load. */
import { loadSimulators, type SimulatorFactory, type Variant } from './load.ts';
import type { SimulatorBindings } from './simulator.ts';

const address = () => new URL('./wasm/meshes/bindings_bg.wasm', import.meta.url);

export const MESHES: Variant = { name: 'meshes', code: () => import('./meshBindings.ts'), address };

/** The variant, whose bindings another module already has. */
export function meshesWith(bindings: SimulatorBindings): Variant {
  return { name: 'meshes', code: async () => bindings, address };
}

/** Loads it; see `loadSimulators`. */
export function loadMeshes(): Promise<SimulatorFactory> {
  return loadSimulators({ physics: MESHES });
}
