/** For tests of the drawing itself, which do not concern the looks of presets. */
export { PLAIN_LOOK } from '../../src/demo/paper/plainLook.ts';
