import type { RemoteMethods } from '../remote/contract.ts';

/** Methods that the element passes to its stage unchanged. It implements all others itself. */
export const HANDED_ON = [
  'step',
  'seek',
  'advance',
  'clear',
  'restart',
  'enter',
  'set',
  'unset',
  'get',
  'picture',
  'save',
  'restore',
  'take',
  'readTake',
  'playTake',
  'hash',
  'stats',
  'pointer',
  'blow',
  'steer',
  'drop',
  'nudge',
  'orbit',
  'zoom',
  'pan',
  'resetView',
  'plane',
] as const satisfies readonly (keyof RemoteMethods)[];

/** Methods of a stage that the element has unchanged. */
export type StageMethods = Pick<RemoteMethods, (typeof HANDED_ON)[number]>;
