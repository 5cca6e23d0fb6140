/** Averages squares of pixels, as coverage of light. */
import { linear } from '../capture/pixels.ts';

/** Linear light, 0 to 1, of each sRGB code. */
export const LINEAR = Float32Array.from({ length: 256 }, (_, code) => linear(code));

/** sRGB codes of 4,096 steps of linear light. */
const CODES = Uint8ClampedArray.from({ length: 4097 }, (_, step) => {
  const value = step / 4096;
  return 255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055);
});

/**
 * Averages squares of `factor` by `factor` pixels with straight alpha, in linear light, weighted by alpha.
 * @param picture its sides are multiples of the factor
 */
export function downsample(picture: ImageData, factor: number): ImageData {
  if (factor === 1) return picture;
  const [width, height] = [picture.width / factor, picture.height / factor];
  const result = new ImageData(width, height);
  for (let y = 0, to = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x, to += 4) average(picture, factor * x, factor * y, factor, result.data, to);
  }
  return result;
}

function average(
  { data, width }: ImageData,
  left: number,
  top: number,
  factor: number,
  result: Uint8ClampedArray,
  to: number,
): void {
  let [red, green, blue, alpha] = [0, 0, 0, 0];
  for (let y = top; y < top + factor; ++y) {
    for (let x = left, at = 4 * (y * width + left); x < left + factor; ++x, at += 4) {
      const weight = data[at + 3];
      red += weight * LINEAR[data[at]];
      green += weight * LINEAR[data[at + 1]];
      blue += weight * LINEAR[data[at + 2]];
      alpha += weight;
    }
  }
  if (alpha === 0) return;
  result[to] = CODES[Math.round((4096 * red) / alpha)];
  result[to + 1] = CODES[Math.round((4096 * green) / alpha)];
  result[to + 2] = CODES[Math.round((4096 * blue) / alpha)];
  result[to + 3] = alpha / factor ** 2;
}

/** The lowest of each square: depths are not averaged, because no surface is at the mean of two. */
export function nearest(depths: Float32Array, width: number, height: number, factor: number): Float32Array {
  if (factor === 1) return depths;
  const [columns, rows] = [width / factor, height / factor];
  const result = new Float32Array(columns * rows).fill(Infinity);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const to = Math.floor(y / factor) * columns + Math.floor(x / factor);
      result[to] = Math.min(result[to], depths[y * width + x]);
    }
  }
  return result;
}

/** The brightest pixel of each square of a grey picture. */
export function brightest(picture: ImageData, factor: number): ImageData {
  if (factor === 1) return picture;
  const [width, height] = [picture.width / factor, picture.height / factor];
  const result = new ImageData(width, height);
  for (let y = 0; y < picture.height; ++y) {
    for (let x = 0; x < picture.width; ++x) {
      const at = 4 * (y * picture.width + x);
      const to = 4 * (Math.floor(y / factor) * width + Math.floor(x / factor));
      for (let channel = 0; channel < 4; ++channel) {
        result.data[to + channel] = Math.max(result.data[to + channel], picture.data[at + channel]);
      }
    }
  }
  return result;
}
