/** How a picture is drawn that no link says: with how many pixels, and what of it. */

/** How many of the screen's pixels are drawn: a share of the pixel ratio, or what the machine can do in time. */
export type Quality = 'auto' | number;

export const LOWEST_QUALITY = 0.25;

/** What can be shown instead of the picture, to see what the passes work with. */
export const DEBUG_VIEWS = ['lit', 'unlit', 'ink', 'normals', 'depth', 'counts', 'overdraw', 'coverage'] as const;
export type DebugView = (typeof DEBUG_VIEWS)[number];
