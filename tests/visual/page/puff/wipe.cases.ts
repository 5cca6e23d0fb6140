/** Wipes of a page whose colours no smoke has. */
import { puff } from '../../../../src/page/puff/puff.ts';
import type { WipeOptions } from '../../../../src/page/puff/options.ts';

declare global {
  interface Window {
    /** Of the test: takes a picture of the page. */
    shoot(moment: string): Promise<void>;
  }
}

/** Wipes the page, or a box of it, and takes pictures before, when it changes and afterwards. */
export async function wiped(options: Omit<WipeOptions, 'to'>, boxStyle?: string) {
  const { style } = document.documentElement;
  style.background = '#ff00ff';
  const box = document.createElement('div');
  box.style.cssText = boxStyle ?? 'display: none';
  document.body.append(box);
  let calls = 0;
  await puff.wipe(boxStyle ? box : undefined, {
    ...options,
    async to() {
      calls++;
      await window.shoot('covered');
      style.background = '#00ff00';
      box.style.background = '#00ff00';
    },
  });
  await window.shoot('after');
  box.remove();
  return { calls, canvases: document.querySelectorAll('canvas').length };
}

/** Wipes whose smoke ends or cannot be drawn: what `to` and the promise of each did. */
export async function interrupted(how: 'escape' | 'clear' | 'hidden' | 'error of to' | 'no code') {
  let calls = 0;
  const over = puff
    .wipe(undefined, {
      to() {
        calls++;
        if (how === 'error of to') throw new RangeError('of the page');
      },
    })
    .then(
      () => 'resolved',
      (error: Error) => error.name,
    );
  await new Promise((resolve) => setTimeout(resolve));
  if (how === 'escape') dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape' }));
  if (how === 'clear') puff.clear();
  if (how === 'hidden') {
    Object.defineProperty(document, 'hidden', { value: true, configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
  }
  const outcome = await over;
  Reflect.deleteProperty(document, 'hidden');
  return { outcome, calls, canvases: document.querySelectorAll('canvas').length };
}
