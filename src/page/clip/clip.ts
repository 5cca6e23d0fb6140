import { fetched } from '../../base/timeout.ts';
import { orderOf, requireSmoke, type ClipOptions, type ClippedSmoke } from './options.ts';

/**
 * Draws what the smoke does from its present moment on, frame by frame on a canvas of its own, and encodes it in a worker. The
 * smoke itself does not change: it goes on playing, or stays paused. Code is loaded with the first clip.
 * @returns the file, of the type image/apng, image/webp or image/gif
 * @throws ParameterError naming the option that is missing, unknown or out of range, UnsupportedError when the browser does not
 * encode the format or the GPU does not draw the size, LoadError when code cannot be fetched, SimulatorError for a smoke with a
 * model that the options lack, the error of a smoke that failed, and the signal's reason
 */
export async function clip(smoke: ClippedSmoke, options: ClipOptions): Promise<Blob> {
  requireSmoke(smoke);
  const order = orderOf(smoke, options);
  const { signal } = order;
  signal.throwIfAborted();
  const { makeClip } = await fetched('The code of clips', import('./makeClip.ts'));
  signal.throwIfAborted();
  return makeClip(smoke, order);
}
