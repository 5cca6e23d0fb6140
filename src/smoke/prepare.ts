import { memoizedCreases, memoizedSeams, meetingBehind } from '../passes/creases.ts';
import { memoizedExtrusion } from '../passes/meshVolumes.ts';
import { memoizedHullNormals, type SurfaceDescription } from '../passes/surfaces.ts';
import { inPieces, type Work } from '../puffs/work.ts';
import type { Device } from '../device/device.ts';
import { lobeBodyShaders } from '../passes/bodies.ts';
import { lobeVolumeShaders } from '../passes/volumes.ts';
import type { Values } from '../preset/parameter.ts';
import { LivePuffs } from './livePuffs.ts';

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

/**
 * Has the two programs compiled that take longest, those of puffs as these values describe them, while other things are on
 * their way. Other programs are small, or belong to what few people ask for.
 */
export function compileAhead(device: Device, values: Values): void {
  if (!device.isUsable || values['puff.form'] !== 'lobes') return;
  const lobes = values['puff.lobes'] as number;
  device.programs.compile(device.renderer, lobeBodyShaders(lobes, !device.writesDepth));
  if (device.writesDepth) device.programs.compile(device.renderer, lobeVolumeShaders(lobes));
}

/** Spent at a time: a page goes on answering in between. */
const PIECE_MS = 16;

/**
 * Bakes the puffs that values describe while a scene and its simulator are still on their way; whoever asks for them next
 * has them at once.
 */
export async function bakeAhead(values: Values): Promise<void> {
  const puffs = new LivePuffs(values);
  while (!puffs.workFor(PIECE_MS)) await nextTask();
}

function nextTask(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}
