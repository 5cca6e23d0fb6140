import type { RemoteMethods } from '../remote/contract.ts';

/** What an element hands on to its stage as it is; what is missing here, an element does in its own way, or by itself. */
export const HANDED_ON = [
  'step',
  'seek',
  'advance',
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

export type HandedOn = Pick<RemoteMethods, (typeof HANDED_ON)[number]>;
