/**
 * The poster: a picture of the linked preset in place of the stage until the first frame. This module is part of the
 * page's first script, so it imports nothing.
 */

/** URLs of the posters that `npm run thumbnails` draws, by path. */
const files: Readonly<Record<string, string>> = import.meta.glob('./posters/*.webp', {
  query: '?url&no-inline',
  import: 'default',
  eager: true,
});

const FIRST_PRESET = 'lamp';
/** Keys of a link that change neither the colours nor the framing of a preset. */
const OTHER_KEYS = /^(v|preset|take|seed|(emission|simulation)\..+)$/;

let poster: HTMLImageElement | undefined;

/**
 * The name of the preset whose picture stands for a link, or undefined: the values of the link or the debug view could
 * look different, and a compressed link is not readable yet.
 * @param search, hash of the page's address
 */
export function posterOf(search: string, hash: string): string | undefined {
  const link = new URLSearchParams(hash.replace(/^#/, ''));
  if (new URLSearchParams(search).has('view') || ![...link.keys()].every((key) => OTHER_KEYS.test(key)))
    return undefined;
  return link.get('preset') ?? FIRST_PRESET;
}

/** Shows the poster of the page's address, if there is one. @param stage the parent, as large as the canvas */
export function showPoster(stage: HTMLElement): void {
  const shape = stage.clientWidth < stage.clientHeight ? 'tall' : 'wide';
  const source = files[`./posters/${posterOf(location.search, location.hash)}.${shape}.webp`];
  if (!source) return;
  poster = Object.assign(new Image(), { className: 'poster', alt: '', fetchPriority: 'high', src: source });
  poster.addEventListener('error', removePoster);
  stage.append(poster);
}

/** Fades the poster out and removes it; at once with reduced motion. */
export async function fadePoster(): Promise<void> {
  poster?.classList.add('is-fading');
  await Promise.allSettled((poster?.getAnimations() ?? []).map(({ finished }) => finished));
  removePoster();
}

export function removePoster(): void {
  poster?.remove();
  poster = undefined;
}
