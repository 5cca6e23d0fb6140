import type { Stage } from '../../stage/stage.ts';
import { strings } from '../strings.ts';
import { pixelSize, type CaptureSettings } from './settings.ts';

/** A stage on a canvas that nobody sees. */
export interface Studio {
  readonly stage: Stage;
  readonly canvas: HTMLCanvasElement;
  /** Draws the moment that the stage stands at; what is drawn can be read in the same task. */
  readonly draw: () => void;
}

/**
 * A copy of what a stage shows, as large as somebody wants it. The stage itself is left as it is, whatever happens in the
 * studio.
 * @throws RangeError for more pixels than the graphics card has room for
 */
export async function openStudio(stage: Stage, settings: CaptureSettings): Promise<Studio> {
  const [width, height] = pixelSize(settings);
  const { scale, hasBackground } = settings;
  // WebKitGTK has no WebGL on an OffscreenCanvas.
  const canvas = document.createElement('canvas');
  const options = { width: 1, height: 1, background: hasBackground, historyBytes: 0 };
  const copy = await stage.copy(canvas, options);
  const max = maxPixels(canvas);
  if (Math.max(width, height) > max) {
    copy.dispose();
    throw new RangeError(strings.capture.tooLarge(width, height, max));
  }
  // Until somebody wants a picture, as few pixels as possible are drawn.
  const draw = () => copy.resize(width / scale, height / scale, scale);
  return { stage: copy, canvas, draw };
}

function maxPixels(canvas: HTMLCanvasElement): number {
  const context = canvas.getContext('webgl2')!;
  return context.getParameter(context.MAX_RENDERBUFFER_SIZE) as number;
}
