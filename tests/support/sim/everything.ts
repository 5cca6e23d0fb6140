import type { View } from '../../../src/simulator/view.ts';

/** A view of all living particles at the current step, without culling. */
export const EVERYTHING: View = {
  purpose: 'eye',
  blend: 1,
  cull: false,
  pad: 0,
  clipFromWorld: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
  direction: [0, 0, -1],
  reach: 1,
  receivers: { min: [-9, -9, -9], max: [9, 9, 9] },
};
