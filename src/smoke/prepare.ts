import { memoizedCreases, memoizedSeams, meetingBehind } from '../passes/creases.ts';
import { memoizedExtrusion } from '../passes/meshVolumes.ts';
import { memoizedHullNormals } from '../passes/surfaceGeometry.ts';
import type { SurfaceDescription } from '../passes/surface.ts';
import { inPieces, type Work } from '../puffs/work.ts';
import type { Device } from '../device/device.ts';
import { lobeBodyShaders } from '../passes/bodies.ts';
import { volumeShaders } from '../passes/volumes.ts';
import type { Values } from '../preset/parameter.ts';
import { isSimplified } from './extraPasses.ts';
import { LivePuffs } from './livePuffs.ts';
import { styleOf } from './style.ts';

/**
 * Computes everything that passes derive from surfaces, in steps of one mesh or one pair of meshes. Results are
 * memoized for the passes that draw them later.
 */
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

/** Like {@link preparingSurfaces}, but keeps the page responsive. */
export function prepareSurfaces(surfaces: readonly SurfaceDescription[]): Promise<void> {
  return inPieces(preparingSurfaces(surfaces));
}

/**
 * Compiles the two slowest programs, the bodies and the volumes of lobe puffs, while other resources load, and resolves
 * when they are ready. Other programs are small or rarely used.
 */
export async function compileAhead(device: Device, values: Values): Promise<void> {
  if (!device.isUsable || values['puff.form'] !== 'lobes') return;
  const lobes = values['puff.lobes'] as number;
  const style = styleOf(values);
  const { isDeformed } = style;
  const kind = { isFlat: !device.writesDepth, isShaded: isSimplified(style), isDeformed };
  device.programs.compile(device.renderer, lobeBodyShaders(lobes, kind));
  device.programs.compile(device.renderer, volumeShaders(lobes, isDeformed));
  await device.programs.finished(device.renderer);
}

/** Time slice in milliseconds, short enough to keep the page responsive. */
const PIECE_MS = 16;

/**
 * Bakes the puffs that values describe while the scene and its simulator load. The puffs are cached for later requests.
 */
export async function bakeAhead(values: Values): Promise<void> {
  const puffs = new LivePuffs(values);
  while (!puffs.workFor(PIECE_MS)) await nextTask();
}

function nextTask(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}
