import { methodNames, type MethodName, type RemoteMethods } from '../remote/methods.ts';

/** Methods of a stage that the element does itself, or that follow from its place on the page. */
const OWN = ['play', 'pause', 'resize', 'setBackground', 'setVisible'] as const satisfies readonly MethodName[];

/** Methods of a stage that the element has unchanged. */
export type StageMethods = Omit<RemoteMethods, (typeof OWN)[number]>;

/** Methods that the element passes to its stage unchanged. */
export const HANDED_ON = methodNames.filter((name): name is keyof StageMethods => !OWN.includes(name as never));
