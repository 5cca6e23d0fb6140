/** Packing of rigids, joints, paths and spins for WASM. Only the variant with physics imports it. */
export { jointNumbers } from './joint.ts';
export { rigidArguments } from './rigid.ts';
export { pathNumbers, spinNumbers } from './rigidPath.ts';
