import { memoizedCreases, memoizedSeams, meetingBehind } from '../passes/creases.ts';
import { memoizedExtrusion } from '../passes/meshVolumes.ts';
import { memoizedHullNormals, type SurfaceDescription } from '../passes/surfaces.ts';
import { inPieces, type Work } from '../puffs/work.ts';

/** All that passes make of surfaces, in pieces: of one mesh, or where two meet. Whoever draws them next has it at once. */
export function* preparingSurfaces(surfaces: readonly SurfaceDescription[]): Work<void> {
  for (const [index, { mesh, casts, inked }] of surfaces.entries()) {
    memoizedHullNormals(mesh);
    yield;
    if (casts) memoizedExtrusion(mesh);
    yield;
    if (!inked) continue;
    memoizedCreases(mesh);
    yield;
    for (const other of meetingBehind(surfaces, index)) {
      memoizedSeams(mesh)(other.mesh);
      yield;
    }
  }
}

/** The same while the page goes on answering. */
export function prepareSurfaces(surfaces: readonly SurfaceDescription[]): Promise<void> {
  return inPieces(preparingSurfaces(surfaces));
}
