/** The bindings of the variant without physics. Named exports keep the generated fetch code out of the bundle. */
export { initSync, lastFault, provokeFault, readTake, Simulator } from './wasm/core/bindings.js';
