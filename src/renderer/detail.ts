/** Levels of detail of the scene's models, by the size of a pixel. */
import { memoize } from './passes/memoize.ts';
import type { SurfaceDescription } from './passes/surface.ts';
import type { TriangleMesh } from './passes/extrusion.ts';

/** Pixels by which triangles may deviate from the finest ones, at the distance of the camera's target. */
const PIXELS = 0.25;
/** Metres. Models are drawn with their finest triangles if only a smaller deviation is allowed. */
const FINEST = 0.005;

/**
 * How far triangles may deviate from the finest ones, in metres, in steps of a factor of sqrt(2); 0 for the finest.
 * @param metresPerPixel at the distance of the camera's target
 */
export function deviationFor(metresPerPixel: number): number {
  const deviation = 2 ** (Math.floor(2 * Math.log2(PIXELS * metresPerPixel)) / 2);
  return deviation < FINEST ? 0 : deviation;
}

/** Memoizes coarser versions of the same type, by their deviation in metres. A deviation of 0 is the source itself. */
function memoizeLevels<Source extends object>(coarsen: (source: Source, deviation: number) => Source) {
  const levelsOf = memoize<Source, Map<number, Source>>((source) => new Map([[0, source]]));
  return (source: Source, deviation: number): Source => {
    const levels = levelsOf(source);
    if (!levels.has(deviation)) levels.set(deviation, coarsen(source, deviation));
    return levels.get(deviation)!;
  };
}

const coarserMesh = memoizeLevels((mesh: TriangleMesh, deviation) =>
  mesh.coarser ? { ...mesh, indices: mesh.coarser(deviation) } : mesh,
);

/** Surfaces with fewer triangles on the same vertices. Surfaces that share a mesh still do. */
export const coarserSurfaces = memoizeLevels((surfaces: readonly SurfaceDescription[], deviation) =>
  surfaces.map((surface) => ({ ...surface, mesh: coarserMesh(surface.mesh, deviation) })),
);
