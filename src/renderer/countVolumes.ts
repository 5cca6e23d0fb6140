import type { RowGeometry } from './gpu/drawnRows.ts';
import type { FrameView } from './gpu/frameView.ts';
import { litThresholdOf } from './palette.ts';
import type { SmokePasses } from './smokePasses.ts';
import type { Style } from './style.ts';

/** Largest count of the stencil buffer. */
export const MAX_COUNT = 255;
/** Distance of the nearest puff, in radii, below which volumes are drawn in tiles. */
const CLOSE = 10;

/** Count from which on more volumes make no difference. */
export function limitOf({ shadowSteps, shadowDepth }: Style): number {
  return shadowSteps === 2 ? Math.min(shadowDepth, MAX_COUNT) : 1;
}

/**
 * Counts the shadow volumes that contain the place at each pixel, in the stencil buffer.
 * @param limit see {@link limitOf}
 */
export function countVolumes(passes: SmokePasses, style: Style, casters: RowGeometry, limit: number): void {
  const { renderer, targets, extras, isFlat } = passes;
  passes.scene?.volumes.draw(renderer);
  passes.mask.countOnce(renderer);
  // Counting needs the depth that fragments write.
  if (style.volumes === 'counted' && !isFlat) {
    extras.countedVolumes!.draw(renderer, casters);
    return;
  }
  const tiled = !isFlat && isCameraClose(passes.eye, passes.bodies.places) ? extras.tiledVolumes : undefined;
  tiled?.setForm(style.form, litThresholdOf(style));
  if (tiled) tiled.drawTiles(renderer, casters, targets, limit);
  else passes.volumes.draw(renderer, casters, targets.copyDepth(renderer), limit);
}

/** Whether the nearest puff is close. @param places x, y, z and radius of the visible puffs, near to far */
function isCameraClose({ uniforms }: FrameView, [x, y, z, radius]: Float32Array): boolean {
  const e = uniforms.viewFromWorld.value.elements;
  return e[2] * x + e[6] * y + e[10] * z + e[14] > -CLOSE * radius;
}
