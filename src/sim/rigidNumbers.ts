/** How rigids, their joints, paths and spins cross into WASM: comes with the variant that has physics. */
export { jointNumbers } from './joint.ts';
export { rigidArguments } from './rigid.ts';
export { pathNumbers, spinNumbers } from './rigidPath.ts';
