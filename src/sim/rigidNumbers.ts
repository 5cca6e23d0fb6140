/** Packing of rigids and joints for WASM. Only the variant with physics imports it. */
export { jointNumbers } from './joint.ts';
export { rigidArguments } from './rigid.ts';
