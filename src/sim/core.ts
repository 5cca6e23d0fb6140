/** What is used of the bindings of the small variant; how they would fetch the module themselves stays out of what pages fetch. */
export { initSync, lastFault, provokeFault, readTake, Simulator } from './wasm/core/bindings.js';
