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
