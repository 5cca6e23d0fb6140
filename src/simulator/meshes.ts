/** The variant with meshes that move as they are told and with rare forces, in a module that few pages load. */
import { loadSimulators, type LoadOptions, type SimulatorFactory, type Variant } from './load.ts';

export const MESHES: Variant = {
  name: 'meshes',
  code: () => import('./meshBindings.ts'),
  address: () => new URL('./wasm/meshes/bindings_bg.wasm', import.meta.url),
};

/** Loads it; see `loadSimulators`. */
export function loadMeshes(onProgress?: LoadOptions['onProgress']): Promise<SimulatorFactory> {
  return loadSimulators({ physics: MESHES, onProgress });
}
