/** The bindings of the variant with meshes, and the packing of its rigids. */
export { initSync, lastFault, provokeFault, readTake, Simulator } from './wasm/meshes/bindings.js';
export { rigidArguments } from './rigidArguments.ts';
