/** The bindings of the variant with physics, and the packing of its rigids. */
export { initSync, lastFault, provokeFault, readTake, Simulator } from './wasm/physics/bindings.js';
export { rigidArguments } from './rigidArguments.ts';
/** Whether rigids fall and collide with each other. */
export const hasDynamics = true;
