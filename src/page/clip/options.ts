import { ParameterError, requireOptions, UnsupportedError } from '../../base/errors.ts';
import type { Values } from '../../parameters/parameter.ts';
import type { ModelOptions } from '../../stage/contract.ts';
import { FASTEST, LONGEST_SIDE, type ClipFormat } from './clipFile.ts';

/** An element `<cartoon-smoke>`, a `RemoteStage` or a `Stage`. */
export interface ClippedSmoke {
  get(): Values | Promise<Values>;
  save(): Uint8Array | Promise<Uint8Array>;
}

export interface ClipOptions {
  /**
   * `apng` has exact colours and alpha, `webp` exact alpha and a small loss of colour, `gif` 256 colours for each frame, and pixels
   * that are opaque or transparent.
   */
  format: ClipFormat;
  /** Length in seconds, 0.1 to 60. The clip has at least one frame. */
  duration: number;
  /** Frames per second, 1 to 60; of a GIF at most 30. Default: 24. */
  fps?: number;
  /** Size in CSS pixels, at most 16,383 pixels of the file per side. Default: the size of the element. */
  width?: number;
  height?: number;
  /** Pixels of the file per CSS pixel, 0.1 to 4. Default: 1. */
  pixelRatio?: number;
  /** Whether to draw the background. Default: false, so the clip is transparent. */
  background?: boolean;
  /**
   * Whether the last frames dissolve into what is before the first one, so that the loop has no seam. The first frame is then up to
   * 0.75 s later, at most half of the duration. Default: true. The file plays endlessly in any case.
   */
  loop?: boolean;
  /** The file that `setModel` was called with, if the smoke has a model. A `Stage` needs none. */
  model?: Uint8Array;
  modelOptions?: ModelOptions;
  /** Called after each frame with the fraction of the frames that are drawn, up to 1. */
  onProgress?: (share: number) => void;
  /** Cancels the clip. The promise then rejects with the signal's reason. */
  signal?: AbortSignal;
}

/** Valid options with their defaults. */
export type ClipOrder = Required<Omit<ClipOptions, 'model' | 'modelOptions'>> &
  Pick<ClipOptions, 'model' | 'modelOptions'>;

const FORMATS: readonly ClipFormat[] = ['apng', 'webp', 'gif'];
/** Browsers slow down GIFs above 50 frames per second, and delays are in hundredths of a second. */
const FASTEST_GIF = 30;
const OPTIONS =
  'format duration fps width height pixelRatio background loop model modelOptions onProgress signal'.split(' ');

/** @throws ParameterError for what is no smoke, UnsupportedError without WebGL2 */
export function requireSmoke(smoke: unknown): asserts smoke is ClippedSmoke {
  const { get, save } = (smoke ?? {}) as Partial<ClippedSmoke>;
  if (typeof get !== 'function' || typeof save !== 'function')
    throw new ParameterError('clip.smoke', smoke, 'an element <cartoon-smoke>, a RemoteStage or a Stage');
  if (isElement(smoke) && !smoke.isConnected)
    throw new ParameterError('clip.smoke', smoke, 'an element that is in the page');
  // On a server, and where the element shows its fallback, it has no smoke.
  if (!globalThis.WebGL2RenderingContext) throw new UnsupportedError('Clips need a browser with WebGL2.');
}

/** @throws ParameterError naming the option that is missing, unknown or out of range */
export function orderOf(smoke: unknown, options: ClipOptions): ClipOrder {
  requireOptions('clip', options, OPTIONS);
  const own = isElement(smoke) && { width: smoke.clientWidth, height: smoke.clientHeight };
  const given = Object.entries(options).filter(([, value]) => value !== undefined);
  const order = { ...defaults(), ...own, ...Object.fromEntries(given) } as ClipOrder;
  const { format, pixelRatio, signal, model } = order;
  if (!FORMATS.includes(format)) throw new ParameterError('clip.format', format, `one of ${FORMATS.join(', ')}`);
  requireInRange(order, 'duration', 0.1, 60, 'seconds');
  requireInRange(order, 'fps', 1, format === 'gif' ? FASTEST_GIF : FASTEST, `frames per second as ${format}`);
  requireInRange(order, 'pixelRatio', 0.1, 4, 'pixels per CSS pixel');
  for (const side of ['width', 'height'] as const) {
    const hint = options[side] === undefined ? '. The smoke has no size of its own' : '';
    requireInRange(order, side, 1, LONGEST_SIDE / pixelRatio, `CSS pixels${hint}`);
  }
  requireType(order, 'background', 'boolean', 'true or false');
  requireType(order, 'loop', 'boolean', 'true or false');
  requireType(order, 'onProgress', 'function', 'a function');
  if (!(signal instanceof AbortSignal)) throw new ParameterError('clip.signal', signal, 'an AbortSignal');
  if (model !== undefined && !(model instanceof Uint8Array))
    throw new ParameterError('clip.model', model, 'the bytes of a GLB file');
  return order;
}

function defaults(): Partial<ClipOrder> {
  const { signal } = new AbortController();
  return { fps: 24, pixelRatio: 1, background: false, loop: true, onProgress: () => undefined, signal };
}

function isElement(smoke: unknown): smoke is Element {
  return typeof Element !== 'undefined' && smoke instanceof Element;
}

function requireInRange(
  order: ClipOrder,
  name: 'duration' | 'fps' | 'width' | 'height' | 'pixelRatio',
  min: number,
  max: number,
  unit: string,
): void {
  const value: unknown = order[name];
  if (typeof value === 'number' && value >= min && value <= max) return;
  throw new ParameterError(`clip.${name}`, value, `a number from ${min} to ${max} ${unit}`);
}

function requireType(order: ClipOrder, name: keyof ClipOrder, type: string, accepted: string): void {
  if (typeof order[name] !== type) throw new ParameterError(`clip.${name}`, order[name], accepted);
}
