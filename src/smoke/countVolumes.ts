import type { RowGeometry } from '../device/drawnRows.ts';
import type { SmokePasses } from './smokePasses.ts';
import type { Style } from './style.ts';

/** Largest count of the stencil buffer. */
export const MAX_COUNT = 255;

/**
 * Counts the shadow volumes that contain the place at each pixel, in the stencil buffer.
 * @param limit count from which on more volumes make no difference, 1..MAX_COUNT
 */
export function countVolumes(passes: SmokePasses, { volumes }: Style, casters: RowGeometry, limit: number): void {
  const { renderer, targets, extras } = passes;
  passes.meshVolumes.draw(renderer);
  passes.mask.countOnce(renderer);
  // Counting needs the depth that fragments write.
  if (volumes === 'counted' && !passes.isFlat) extras.countedVolumes!.draw(renderer, casters);
  else passes.volumes.draw(renderer, casters, targets.copyDepth(renderer), limit);
}
