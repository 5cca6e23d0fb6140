import type { WebGLRenderTarget } from 'three';
import { createDevice, type Device, type DeviceCanvas, type DeviceOptions } from '../device/device.ts';
import { Enlarger } from '../device/enlarger.ts';
import { ContextError } from '../preset/errors.ts';

/** Brings pictures to a stage's canvas: it owns the device there, or copies from a device that stages share. */
export interface Presenter {
  readonly device: Device;
  /**
   * Gives the device's canvas its size, in pixels, and returns what to draw the coming picture into: null is the canvas.
   * @param drawn size of the coming picture; what is smaller than the canvas is enlarged on its way there
   */
  prepare(canvas: PictureSize, drawn: PictureSize): WebGLRenderTarget | null;
  /** Brings the picture to the stage's canvas; must run in the task that drew it. */
  present(): void;
  /** The picture that was just drawn as a PNG; must be called in the task that drew it. */
  encode(): Promise<Blob>;
  dispose(): void;
}

/** In pixels. */
export interface PictureSize {
  width: number;
  height: number;
}

/**
 * @param shared a device whose own canvas is an OffscreenCanvas; without it the stage gets a device of its own
 * @param options of that
 */
export function createPresenter(canvas: DeviceCanvas, shared?: Device, options: DeviceOptions = {}): Presenter {
  return shared ? copyFrom(shared, canvas) : drawOn(createDevice(canvas, options));
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
  // Workers do not know the class of the other kind.
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
    // The shared canvas is blank again after the transfer, this one holds the picture.
    encode: () => encodePng(canvas),
    dispose() {
      size.dispose();
      context.transferFromImageBitmap(null);
    },
  };
}

/** Lets pictures be smaller than the canvas that shows them. */
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

/** What a canvas shows as a PNG; one with WebGL shows it until the task ends that drew it. */
export function encodePng(canvas: DeviceCanvas): Promise<Blob> {
  if ('convertToBlob' in canvas) return canvas.convertToBlob({ type: 'image/png' });
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new ContextError('The picture could not be encoded.'))),
      'image/png',
    );
  });
}
