/** Elements with injected faults, which only the sources support, and their effects on a page. */
import type { ElementOptions } from '../../../../src/page/element/cartoonSmokeElement.ts';
import { CartoonSmokeElement } from '../../../../src/element.ts';
import { puff, type OwnPuff, type Puff } from '../../../../src/page/puff/puff.ts';

export interface Shown {
  readonly element: CartoonSmokeElement;
  /** Events of the element, by type and error name. */
  readonly notified: string[];
}

/** Adds a small wisp with a poster and a fallback to the page. */
export function show(thread: 'auto' | 'main' | 'worker', options: ElementOptions = {}): Shown {
  const element = new CartoonSmokeElement(options);
  Object.assign(element, { preset: 'wisp', simulationMaxParticles: 300, thread, loading: 'eager' });
  element.style.cssText = 'display: block; width: 160px; height: 120px';
  element.innerHTML = '<p slot="poster">Poster</p><p>Fallback</p>';
  const notified: string[] = [];
  element.addEventListener('ready', ({ detail }) => notified.push(`ready on ${detail.thread}`));
  element.addEventListener('error', ({ detail }) => notified.push(detail.error.name));
  document.body.append(element);
  return { element, notified };
}

/** Several elements side by side. */
export function showSome(count: number, thread: 'main' | 'worker'): Shown[] {
  const shown = Array.from({ length: count }, () => show(thread));
  for (const { element } of shown) {
    element.style.cssText = 'display: inline-block; width: 48px; height: 36px';
    Object.assign(element, { puffVariations: 1 });
  }
  return shown;
}

/** Resolves when all elements have advanced and show smoke. */
export async function allDraw(shown: readonly Shown[]): Promise<void> {
  await Promise.all(
    shown.map(async (one) => {
      const { steps } = await one.element.stats();
      while ((await one.element.stats()).steps < steps + 3 || (await colorsOf(one)) < 4) {
        await new Promise(requestAnimationFrame);
      }
    }),
  );
}

/** Whether poster and fallback replace the smoke, and the button is hidden or, after a lost context, restarts. */
export function isGivenUp({ element, notified }: Shown): boolean {
  const [poster, fallback] = [...element.children].map((child) => child.checkVisibility());
  const button = element.shadowRoot!.querySelector('button')!;
  const isLost = notified.at(-1) === 'ContextError';
  const isRestart = button.checkVisibility() && button.ariaLabel === 'Restart smoke';
  return poster && fallback && !element.playing && (isLost ? isRestart : !button.checkVisibility());
}

/** Number of colours on the element's canvas. */
export function colorsOf({ element }: Shown): Promise<number> {
  return colorsOn(element.shadowRoot!.querySelector('canvas')!);
}

/** Number of colours on a canvas. */
export async function colorsOn(canvas: HTMLCanvasElement): Promise<number> {
  const bitmap = await createImageBitmap(canvas);
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  return new Set(new Uint32Array(context.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer)).size;
}

/** A `puff` on a canvas over the page or of the page. */
export function puffOn(place: 'the page' | 'a canvas of the page', thread: 'main' | 'worker'): Puff {
  if (thread === 'main') Reflect.deleteProperty(window, 'Worker');
  return place === 'the page' ? puff : ownPuff();
}

/** A `puff` on the canvas of the page, which is the same at each call. */
export function ownPuff(): OwnPuff {
  ownCanvas ??= document.body.appendChild(document.createElement('canvas'));
  return puff.create(ownCanvas);
}

let ownCanvas: HTMLCanvasElement | undefined;
let lastDrawn: HTMLCanvasElement | null = null;

/** Number of colours that remain on the canvas of the page; 1 without a canvas. */
export async function colorsLeft(): Promise<number> {
  const canvas = document.querySelector('canvas');
  return canvas ? colorsOn(canvas) : 1;
}

/** A call that lasts: how it ends, once its smoke is drawn. */
export async function puffs(one: Puff): Promise<{ ends: Promise<string> }> {
  const call = { isOver: false };
  const ends = one({ x: 80, y: 60 }, { count: 100, speed: 0.1, duration: 60 }).then(
    () => 'done',
    (error: Error) => `${error.name}: ${error.message}`,
  );
  void ends.then(() => (call.isOver = true));
  for (; !call.isOver; await new Promise(requestAnimationFrame)) {
    const canvas = document.querySelector('canvas');
    // The last one keeps its picture until the next one takes its place.
    if (!canvas || canvas === lastDrawn || (await colorsOn(canvas)) < 4) continue;
    lastDrawn = canvas;
    break;
  }
  return { ends };
}

/** Adds elements and removes each as soon as it plays. */
export async function comeAndGo(rounds: number, thread: 'auto' | 'main'): Promise<void> {
  for (let round = 0; round < rounds; ++round) {
    const { element } = show(thread);
    await element.ready;
    element.remove();
    // Removal takes effect in a later task, because the element may only have been moved.
    await new Promise((resolve) => setTimeout(resolve));
  }
}
