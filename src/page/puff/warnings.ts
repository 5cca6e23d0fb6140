/** Warnings about `puff()`: what makes its smoke invisible, and failures. */
import { warnOfError, warnOnce } from '../../base/warn.ts';
import type { PuffOptions, WipeOptions } from './options.ts';
import type { OwnPuff, Puff } from './puff.ts';
import type { PuffTarget } from './target.ts';

const ABOUT = 'puff()';

/** @returns a function that does what the given one does, with warnings */
export function watch<Kind extends Puff>(puff: Kind): Kind {
  const handled = <Result>(work: Promise<Result>) => {
    work.catch((error: Error) => warnOfError(ABOUT, error));
    return work;
  };
  const watched = (target?: PuffTarget, options?: PuffOptions) => {
    judge(target, options);
    return handled(puff(target, options));
  };
  return Object.assign(watched, puff, {
    wipe: (target: PuffTarget | undefined, options: WipeOptions) => handled(puff.wipe(target, options)),
    preload: () => handled(puff.preload()),
    create: (canvas: HTMLCanvasElement): OwnPuff => watch(puff.create(canvas)),
  });
}

function judge(target: PuffTarget | undefined, options: PuffOptions | undefined): void {
  if (target === null) {
    warnOnce(
      ABOUT,
      'The target is null, so smoke starts in the middle of the window. Does the selector match no element, or is the reference not set yet?',
    );
  }
  if (options?.reducedMotion !== 'play' && globalThis.matchMedia?.('(prefers-reduced-motion: reduce)').matches) {
    return warnOnce(
      ABOUT,
      'The system prefers reduced motion, so no smoke is visible. { reducedMotion: \u201cplay\u201d } shows it.',
    );
  }
  // Simulated DOMs have no layout.
  if (typeof WebGL2RenderingContext === 'undefined') return;
  const box = (target as Partial<Element> | null | undefined)?.getBoundingClientRect?.();
  if (box && !(box.width > 0 && box.height > 0)) {
    warnOnce(
      ABOUT,
      'The target has no box, so no smoke is visible. Is the element outside of the document, without a size or hidden by display: none?',
    );
  }
}
