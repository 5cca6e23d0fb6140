/** The same of the variant with physics, and how rigids cross into it. */
export { initSync, lastFault, provokeFault, readTake, Simulator } from './wasm/physics/bindings.js';
export * as rigidNumbers from './rigidNumbers.ts';
