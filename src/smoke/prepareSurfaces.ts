import { keptCreases, keptSeams, meetingBehind } from '../passes/creases.ts';
import { keptExtrusion } from '../passes/meshVolumes.ts';
import { keptHullNormals, type SurfaceDescription } from '../passes/surfaces.ts';
import { inPieces, type Work } from '../puffs/work.ts';

/** All that passes make of surfaces, in pieces: of one mesh, or where two meet. Whoever draws them next has it at once. */
export function* preparingSurfaces(surfaces: readonly SurfaceDescription[]): Work<void> {
  for (const [index, { mesh, casts, inked }] of surfaces.entries()) {
    keptHullNormals(mesh);
    yield;
    if (casts) keptExtrusion(mesh);
    yield;
    if (!inked) continue;
    keptCreases(mesh);
    yield;
    for (const other of meetingBehind(surfaces, index)) {
      keptSeams(mesh)(other.mesh);
      yield;
    }
  }
}

/** The same while the page goes on answering. */
export function prepareSurfaces(surfaces: readonly SurfaceDescription[]): Promise<void> {
  return inPieces(preparingSurfaces(surfaces));
}
