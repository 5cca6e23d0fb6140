/** Reads what was just drawn on a canvas, again and again. */
export class PixelReader {
  private readonly canvas: OffscreenCanvas;
  private readonly context: OffscreenCanvasRenderingContext2D;

  /** @param width, height of the canvases that it will read, in pixels */
  constructor(width: number, height: number) {
    this.canvas = new OffscreenCanvas(width, height);
    this.context = this.canvas.getContext('2d', { willReadFrequently: true })!;
  }

  /** Colours with straight alpha; must be called in the task that drew the source. */
  read(source: HTMLCanvasElement): ImageData {
    const { width, height } = this.canvas;
    this.context.clearRect(0, 0, width, height);
    this.context.drawImage(source, 0, 0);
    return this.context.getImageData(0, 0, width, height);
  }

  /** Pixels as a PNG. */
  encode(pixels: ImageData): Promise<Blob> {
    this.context.putImageData(pixels, 0, 0);
    return this.canvas.convertToBlob({ type: 'image/png' });
  }
}
