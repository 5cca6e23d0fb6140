import { createDevice, type Device, type DeviceCanvas } from '../device/device.ts';
import { ContextError } from '../preset/errors.ts';
import { bakedPuffs } from '../smoke/bakedPuffs.ts';

/** Brings pictures to a stage's canvas: it owns the device there, or copies from a device that stages share. */
export interface Presenter {
  readonly device: Device;
  /** Gives the device's canvas the size of the coming picture, in pixels. */
  prepare(width: number, height: number): void;
  /** Brings the picture to the stage's canvas; must run in the task that drew it. */
  present(): void;
  /** The picture that was just drawn as a PNG; must be called in the task that drew it. */
  encode(): Promise<Blob>;
  dispose(): void;
}

/** @param shared a device whose own canvas is an OffscreenCanvas; without it the stage gets a device of its own */
export function createPresenter(canvas: DeviceCanvas, shared?: Device): Presenter {
  return shared ? copyFrom(shared, canvas) : drawOn(createDevice(canvas, bakedPuffs()));
}

function drawOn(device: Device): Presenter {
  return {
    device,
    prepare: (width, height) => resize(device, width, height),
    present: () => {},
    encode: () => encode(device.canvas),
    dispose: () => device.dispose(),
  };
}

function copyFrom(device: Device, canvas: DeviceCanvas): Presenter {
  const source = device.canvas;
  if (source instanceof HTMLCanvasElement)
    throw new ContextError('A shared device must be created on an OffscreenCanvas.');
  const context = canvas.getContext('bitmaprenderer');
  if (!context) throw new ContextError('This canvas already has another context; give the stage a fresh canvas.');
  return {
    device,
    prepare: (width, height) => resize(device, width, height),
    present: () => context.transferFromImageBitmap(source.transferToImageBitmap()),
    // The shared canvas is blank again after the transfer, this one holds the picture.
    encode: () => encode(canvas),
    dispose: () => context.transferFromImageBitmap(null),
  };
}

function resize({ renderer, canvas }: Device, width: number, height: number): void {
  if (canvas.width !== width || canvas.height !== height) renderer.setSize(width, height, false);
}

function encode(canvas: DeviceCanvas): Promise<Blob> {
  if ('convertToBlob' in canvas) return canvas.convertToBlob({ type: 'image/png' });
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new ContextError('The picture could not be encoded.'))),
      'image/png',
    );
  });
}
