import { DataTexture, DataUtils, FloatType, HalfFloatType, RGBAFormat, type TextureDataType } from 'three';
import { EXRExporter } from 'three/examples/jsm/exporters/EXRExporter.js';
import { LINEAR } from './downsample.ts';

/** Encodes a picture with straight alpha as linear half floats, premultiplied as OpenEXR defines it. */
export function encodeExr({ data, width, height }: ImageData): Promise<Blob> {
  const halves = new Uint16Array(data.length);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const at = 4 * (y * width + x);
      // The exporter takes rows from the bottom up.
      const to = 4 * ((height - 1 - y) * width + x);
      const alpha = data[at + 3] / 255;
      for (let channel = 0; channel < 3; ++channel) {
        halves[to + channel] = DataUtils.toHalfFloat(alpha * LINEAR[data[at + channel]]);
      }
      halves[to + 3] = DataUtils.toHalfFloat(alpha);
    }
  }
  return exported(halves, width, height, HalfFloatType);
}

/**
 * Encodes depths as 32-bit floats in red, green and blue; alpha is 1.
 * @param depths rows from the bottom up
 */
export function encodeDepth(depths: Float32Array, width: number, height: number): Promise<Blob> {
  const floats = new Float32Array(4 * depths.length);
  depths.forEach((depth, at) => floats.set([depth, depth, depth, 1], 4 * at));
  return exported(floats, width, height, FloatType);
}

async function exported(
  data: Uint16Array<ArrayBuffer> | Float32Array<ArrayBuffer>,
  width: number,
  height: number,
  type: TextureDataType,
): Promise<Blob> {
  const texture = new DataTexture(data, width, height, RGBAFormat, type);
  const bytes = await new EXRExporter().parse(texture, { type });
  return new Blob([bytes], { type: 'image/x-exr' });
}
