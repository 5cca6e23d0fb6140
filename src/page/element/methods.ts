import type { RemoteMethods } from '../../stage/remote/calls.ts';
import names from './methods.json' with { type: 'json' };

/** Methods of a stage that the element has unchanged. It does the others itself, by attributes and its place. */
export type StageMethods = Omit<RemoteMethods, 'play' | 'pause' | 'resize' | 'setBackground' | 'setVisible'>;

/**
 * Their names. The list of methods with its checks is loaded with the smoke; before that, the element has only the
 * names, which `npm run generate` writes of the list.
 */
export const HANDED_ON = names.split(' ') as (keyof StageMethods)[];
