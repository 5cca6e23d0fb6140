import type { Stage } from '../../index.ts';
import { strings } from '../strings.ts';
import { pixelSize, type CaptureSettings } from './settings.ts';

/** A stage on an offscreen canvas. */
export interface Studio {
  readonly stage: Stage;
  readonly canvas: HTMLCanvasElement;
  /** Draws the stage at its current time. The pixels can be read within the same task. */
  readonly draw: () => void;
}

/**
 * Opens a copy of a stage at the requested size. The original stage is not modified.
 * @throws RangeError when the size exceeds the limit of the GPU
 */
export async function openStudio(stage: Stage, settings: CaptureSettings): Promise<Studio> {
  const [width, height] = pixelSize(settings);
  const { scale, hasBackground } = settings;
  // WebKitGTK does not support WebGL on an OffscreenCanvas.
  const canvas = document.createElement('canvas');
  const options = { width: 1, height: 1, background: hasBackground, historyBytes: 0 };
  const copy = await stage.copy(canvas, options);
  const max = maxPixels(canvas);
  if (Math.max(width, height) > max) {
    copy.dispose();
    throw new RangeError(strings.capture.tooLarge(width, height, max));
  }
  // The canvas stays at its minimum size until a frame is requested.
  const draw = () => copy.resize(width / scale, height / scale, scale);
  return { stage: copy, canvas, draw };
}

function maxPixels(canvas: HTMLCanvasElement): number {
  const context = canvas.getContext('webgl2')!;
  return context.getParameter(context.MAX_RENDERBUFFER_SIZE) as number;
}
