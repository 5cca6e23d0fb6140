import type { Stage } from '../../index.ts';
import { openStudio, type Studio } from '../../internal.ts';
import { pixelSize, type CaptureSettings } from './settings.ts';

/**
 * Opens a copy of a stage at the requested size. The original stage is not modified.
 * @throws UnsupportedError when the size exceeds the limit of the GPU
 */
export function openCopy(stage: Stage, settings: CaptureSettings): Promise<Studio> {
  const [width, height] = pixelSize(settings);
  const { scale, hasBackground } = settings;
  return openStudio((canvas, options) => stage.copy(canvas, options), { width, height, scale, hasBackground });
}

/** The browser has no encoder for a format. The message suggests an alternative. */
export class VideoError extends Error {
  override name = 'VideoError';
}
