import { Matrix4, Vector4 } from 'three';
import { ALL_THAT_LIVES, PLACE_FLOATS, STEP_SECONDS, type FrameInput } from '../../internal.ts';

/** Displacement of a full channel, as a fraction of the frame's side. */
export const MOTION_RANGE = 0.125;

/** Puffs reach beyond their radius, and ink beyond puffs. Pixels up to this many radii away move like the nearest puff. */
const REACH = 1.6;

/** Colour of no motion. */
const STILL = [128, 128, 0, 255];

/** Added to the depth of pixels outside a puff's radius, so that every puff within its radius covers them. */
const OUTSIDE = 1e6;

/**
 * Draws motion vectors of the smoke: the displacement of each pixel until the next frame, as a fraction of the frame's
 * sides. Red is x to the right, green is y up, 0 to 255 for -{@link MOTION_RANGE} to {@link MOTION_RANGE}. All pixels
 * are opaque; those without smoke do not move. Neither the camera nor objects have motion vectors.
 * @param width, height in pixels
 * @param rate frames per second
 * @returns four bytes per pixel, rows from the top
 */
export function drawMotion(
  input: Pick<FrameInput, 'simulator' | 'camera' | 'blend'>,
  width: number,
  height: number,
  rate: number,
): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(4 * width * height);
  for (let at = 0; at < pixels.length; at += 4) pixels.set(STILL, at);
  const nearest = new Float32Array(width * height).fill(Infinity);
  const { rows } = input.simulator.arrange({ ...ALL_THAT_LIVES, blend: input.blend });
  const moves = input.simulator.moves();
  const clipFromWorld = new Matrix4().multiplyMatrices(input.camera.projectionMatrix, input.camera.matrixWorldInverse);
  const [xOfRadius, yOfRadius] = [input.camera.projectionMatrix.elements[0], input.camera.projectionMatrix.elements[5]];
  const scale = 1 / (STEP_SECONDS * rate);
  for (let row = 0; row < rows.count; ++row) {
    const [x, y, z, radius] = rows.place.subarray(PLACE_FLOATS * row);
    const [dx, dy, dz] = moves.subarray(3 * row);
    const here = new Vector4(x, y, z, 1).applyMatrix4(clipFromWorld);
    const next = new Vector4(x + dx * scale, y + dy * scale, z + dz * scale, 1).applyMatrix4(clipFromWorld);
    if (here.w <= 0 || next.w <= 0 || radius === 0) continue;
    const red = channel((next.x / next.w - here.x / here.w) / 2);
    const green = channel((next.y / next.w - here.y / here.w) / 2);
    const [centreX, centreY] = [((1 + here.x / here.w) * width) / 2, ((1 - here.y / here.w) * height) / 2];
    const [radiusX, radiusY] = [(xOfRadius * radius * width) / 2 / here.w, (yOfRadius * radius * height) / 2 / here.w];
    const [top, bottom] = within(centreY, REACH * radiusY, height);
    const [left, right] = within(centreX, REACH * radiusX, width);
    for (let pixelY = top; pixelY <= bottom; ++pixelY) {
      const v = ((pixelY + 0.5 - centreY) / radiusY) ** 2;
      for (let pixelX = left; pixelX <= right; ++pixelX) {
        const squared = v + ((pixelX + 0.5 - centreX) / radiusX) ** 2;
        if (squared > REACH ** 2) continue;
        const depth = squared <= 1 ? here.w - radius * Math.sqrt(1 - squared) : OUTSIDE + radius * Math.sqrt(squared);
        const at = pixelY * width + pixelX;
        if (depth >= nearest[at]) continue;
        nearest[at] = depth;
        pixels[4 * at] = red;
        pixels[4 * at + 1] = green;
      }
    }
  }
  return pixels;
}

function channel(displacement: number): number {
  return Math.round(127.5 * (1 + Math.min(1, Math.max(-1, displacement / MOTION_RANGE))));
}

/** First and last pixel of a span, within a picture. */
function within(centre: number, reach: number, size: number): [number, number] {
  return [Math.max(0, Math.floor(centre - reach)), Math.min(size - 1, Math.ceil(centre + reach))];
}
