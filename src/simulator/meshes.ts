/** The variant with meshes that move as they are told, in a module that only three.js scenes contain. */
import type { Variant } from './load.ts';

export const MESHES: Variant = {
  name: 'meshes',
  code: () => import('./meshBindings.ts'),
  address: () => new URL('./wasm/meshes/bindings_bg.wasm', import.meta.url),
};
