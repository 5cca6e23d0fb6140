import type { WebGLRenderTarget } from 'three';
import {
  contextAhead,
  createDevice,
  type Device,
  type DeviceCanvas,
  type DeviceOptions,
} from '../renderer/gpu/device.ts';
import { Enlarger } from '../renderer/gpu/enlarger.ts';
import { ContextError } from '../base/errors.ts';

/** Presents pictures on a stage's canvas. It either owns the device of that canvas or copies from a shared device. */
export interface Presenter {
  readonly device: Device;
  /**
   * Resizes the device's canvas, in pixels, and returns the render target for the next picture; null is the canvas.
   * @param drawn size of the next picture; a picture smaller than the canvas is upscaled
   */
  prepare(canvas: PictureSize, drawn: PictureSize): WebGLRenderTarget | null;
  /** Copies the picture to the stage's canvas. Must run in the task that drew it. */
  present(): void;
  /** Encodes the picture just drawn as a PNG. Must be called in the task that drew it. */
  encode(): Promise<Blob>;
  dispose(): void;
}

/** In pixels. */
export interface PictureSize {
  width: number;
  height: number;
}

/**
 * @param shared a device whose canvas is an OffscreenCanvas; without it, the stage creates its own device
 * @param options for the stage's own device
 */
export async function createPresenter(
  canvas: DeviceCanvas,
  shared?: Device,
  options: DeviceOptions = {},
): Promise<Presenter> {
  if (shared) return copyFrom(shared, canvas);
  await contextAhead(canvas);
  return drawOn(createDevice(canvas, options));
}

function drawOn(device: Device): Presenter {
  const size = new Sizing(device);
  return {
    device,
    prepare: (canvas, drawn) => size.prepare(canvas, drawn),
    present: () => size.finish(),
    encode: () => encodePng(device.canvas),
    dispose() {
      size.dispose();
      device.dispose();
    },
  };
}

function copyFrom(device: Device, canvas: DeviceCanvas): Presenter {
  const source = device.canvas;
  // Not instanceof: OffscreenCanvas or HTMLCanvasElement may be undefined here, as in workers.
  if (!('transferToImageBitmap' in source)) throw new ContextError('A shared device needs an OffscreenCanvas.');
  const context = canvas.getContext('bitmaprenderer');
  if (!context) throw new ContextError('This canvas already has another context. Use a new canvas.');
  const size = new Sizing(device);
  return {
    device,
    prepare: (wanted, drawn) => size.prepare(wanted, drawn),
    present() {
      size.finish();
      context.transferFromImageBitmap(source.transferToImageBitmap());
    },
    // The transfer clears the shared canvas; this canvas holds the picture.
    encode: () => encodePng(canvas),
    dispose() {
      size.dispose();
      context.transferFromImageBitmap(null);
    },
  };
}

/** Draws pictures that are smaller than the canvas and upscales them. */
class Sizing {
  private readonly device: Device;
  private readonly enlarger = new Enlarger();
  private readonly stopListening: () => void;
  private isEnlarging = false;

  constructor(device: Device) {
    this.device = device;
    this.stopListening = device.onContext((event) => (event === 'lost' ? this.enlarger.dispose() : undefined));
  }

  prepare({ width, height }: PictureSize, drawn: PictureSize): WebGLRenderTarget | null {
    const { renderer, canvas } = this.device;
    if (canvas.width !== width || canvas.height !== height) renderer.setSize(width, height, false);
    this.isEnlarging = drawn.width < width || drawn.height < height;
    return this.isEnlarging ? this.enlarger.prepare(drawn.width, drawn.height) : null;
  }

  finish(): void {
    if (this.isEnlarging) this.enlarger.draw(this.device.renderer);
  }

  dispose(): void {
    this.stopListening();
    this.enlarger.dispose();
  }
}

/** Encodes the canvas as a PNG. A WebGL canvas must be encoded in the task that drew it. */
export function encodePng(canvas: DeviceCanvas): Promise<Blob> {
  if ('convertToBlob' in canvas) return canvas.convertToBlob({ type: 'image/png' });
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new ContextError('The picture could not be encoded.'))),
      'image/png',
    );
  });
}
