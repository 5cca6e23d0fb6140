/** Reads back canvases, reusing one buffer. */
export class PixelReader {
  private readonly canvas: OffscreenCanvas;
  private readonly context: OffscreenCanvasRenderingContext2D;

  /** @param width, height of the canvases to read, in pixels */
  constructor(width: number, height: number) {
    this.canvas = new OffscreenCanvas(width, height);
    this.context = this.canvas.getContext('2d', { willReadFrequently: true })!;
  }

  /** Returns straight-alpha pixels. Must be called in the same task that drew the source. */
  read(source: HTMLCanvasElement): ImageData {
    const { width, height } = this.canvas;
    this.context.clearRect(0, 0, width, height);
    this.context.drawImage(source, 0, 0);
    return this.context.getImageData(0, 0, width, height);
  }

  /** Encodes pixels as a PNG. */
  encode(pixels: ImageData): Promise<Blob> {
    this.context.putImageData(pixels, 0, 0);
    return this.canvas.convertToBlob({ type: 'image/png' });
  }
}

/** By how much a channel that is read may deviate: some browsers falsify the lowest bits against fingerprinting. */
export const NOISE = 1;

/** Whether two pixels as 0xAABBGGRR may be the same colour. */
export function isSame(a: number, b: number): boolean {
  return [0, 8, 16, 24].every((shift) => Math.abs(((a >>> shift) & 0xff) - ((b >>> shift) & 0xff)) <= NOISE);
}

/** Converts an sRGB code (0 to 255) to linear light (0 to 1). */
export function linear(code: number): number {
  const value = code / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}
