/** Small pictures of the smoke, as text that fits into the browser's storage. */

const [WIDTH, HEIGHT] = [160, 100];
const QUALITY = 0.8;
/** Of the picture, from its middle: the smoke shall be seen, not the room around it. */
const SHOWN = 0.72;

/** The middle of a picture, small, as base64. */
export async function shrink(picture: Blob): Promise<string> {
  const whole = await createImageBitmap(picture);
  const scale = SHOWN * Math.min(whole.width / WIDTH, whole.height / HEIGHT);
  const [width, height] = [WIDTH * scale, HEIGHT * scale];
  const canvas = createThumbnail();
  const context = canvas.getContext('2d')!;
  context.imageSmoothingQuality = 'high';
  const [left, top] = [(whole.width - width) / 2, (whole.height - height) / 2];
  context.drawImage(whole, left, top, width, height, 0, 0, WIDTH, HEIGHT);
  whole.close();
  return canvas.toDataURL('image/webp', QUALITY).split(',')[1];
}

/** Draws one that `shrink` made; what cannot be read leaves the canvas empty. No address is loaded for it. */
export async function drawThumbnail(canvas: HTMLCanvasElement, picture: string): Promise<void> {
  try {
    const bytes = Uint8Array.from(atob(picture), (character) => character.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes]));
    canvas.getContext('2d')!.drawImage(image, 0, 0, WIDTH, HEIGHT);
    image.close();
  } catch {
    canvas.classList.add('is-empty');
  }
}

/** An empty one. */
export function createThumbnail(): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [WIDTH, HEIGHT];
  return canvas;
}
