/** Rendering settings that are not part of a link: resolution and debug view. */

/** Render resolution as a fraction of the device pixel ratio, or `auto` to adapt it to the frame time. */
export type Quality = 'auto' | number;

export const LOWEST_QUALITY = 0.25;

/** Debug views that show intermediate results of the render passes instead of the image. */
export const DEBUG_VIEWS = ['lit', 'unlit', 'ink', 'normals', 'depth', 'counts', 'overdraw', 'coverage'] as const;
export type DebugView = (typeof DEBUG_VIEWS)[number];
