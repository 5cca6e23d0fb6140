/** Elements with faults that only sources know, and what a page sees of them. */
import type { ElementOptions } from '../../src/element/cartoonSmokeElement.ts';
import { CartoonSmokeElement } from '../../src/element/define.ts';

export interface Shown {
  readonly element: CartoonSmokeElement;
  /** What the element told, by type and by the name of the error. */
  readonly notified: string[];
}

/** Puts a small wisp with a poster and a fallback on the page. */
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

/** Several of them, beside each other. */
export function showSome(count: number, thread: 'main' | 'worker'): Shown[] {
  const shown = Array.from({ length: count }, () => show(thread));
  for (const { element } of shown) {
    element.style.cssText = 'display: inline-block; width: 48px; height: 36px';
    Object.assign(element, { puffVariations: 1 });
  }
  return shown;
}

/** Settled when all of them have gone on, and show smoke. */
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

/** Whether the poster and the fallback stand in the place of the smoke, and nothing can be played. */
export function isGivenUp({ element }: Shown): boolean {
  const [poster, fallback] = [...element.children].map((child) => child.checkVisibility());
  return poster && fallback && !element.shadowRoot!.querySelector('button')!.checkVisibility();
}

/** Colours that the element's canvas shows. */
export async function colorsOf({ element }: Shown): Promise<number> {
  const bitmap = await createImageBitmap(element.shadowRoot!.querySelector('canvas')!);
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  return new Set(new Uint32Array(context.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer)).size;
}

/** Puts elements on the page and takes them away, one after the other, as soon as they play. */
export async function comeAndGo(rounds: number, thread: 'auto' | 'main'): Promise<void> {
  for (let round = 0; round < rounds; ++round) {
    const { element } = show(thread);
    await element.ready;
    element.remove();
    // It ends in a task of its own, because it may only have been moved.
    await new Promise((resolve) => setTimeout(resolve));
  }
}
