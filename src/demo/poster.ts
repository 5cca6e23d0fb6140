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

/** Version of links that have the looks of the posters. */
const VERSION = '1';
/** Preset of a link without one. */
const DEFAULT_PRESET = 'lamp';
/** Preset of an address without a link. */
const FIRST_LOOK = 'cloudscape-cumulus';
/** Keys of a link that change neither the colours nor the framing of a preset. */
const OTHER_KEYS = /^(v|preset|take|seed|(emission|simulation)\..+)$/;

/** The stage does not wait longer than this time in milliseconds for the poster. */
const LATE_MS = 1000;

let poster: HTMLImageElement | undefined;

/** The link in the hash of an address without what hosts append, or the first look if there is none. */
export function linkOf(hash: string): string {
  const [, link] = hash.split(/[#?]|:~:/, 2);
  return link ? `#${link}` : `#v=${VERSION}&preset=${FIRST_LOOK}`;
}

/**
 * The name of the preset whose picture stands for a link, or undefined: the values of the link or the debug view could
 * look different, as can links of other versions, and a compressed link is not readable yet.
 * @param search, hash of the page's address
 */
export function posterOf(search: string, hash: string): string | undefined {
  const link = new URLSearchParams(linkOf(hash).slice(1));
  const isPlain = link.get('v') === VERSION && [...link.keys()].every((key) => OTHER_KEYS.test(key));
  if (new URLSearchParams(search).has('view') || !isPlain) return undefined;
  return link.get('preset') ?? DEFAULT_PRESET;
}

/**
 * Shows the poster of the page's address, if there is one. Resolves when it is on the screen, or late.
 * @param stage the parent, as large as the canvas
 */
export async function showPoster(stage: HTMLElement): Promise<void> {
  const shape = stage.clientWidth < stage.clientHeight ? 'tall' : 'wide';
  const source = files[`./posters/${posterOf(location.search, location.hash)}.${shape}.webp`];
  if (!source) return;
  poster = Object.assign(new Image(), { className: 'poster', alt: '', fetchPriority: 'high', src: source });
  poster.addEventListener('error', removePoster);
  stage.append(poster);
  const late = new Promise((resolve) => setTimeout(resolve, LATE_MS));
  await Promise.race([isPainted(poster), late]);
}

/** Resolves when an image is on the screen, after nothing else that browsers count as content. */
async function isPainted(image: HTMLImageElement): Promise<void> {
  await image.decode().catch(() => undefined);
  await new Promise<void>((resolve) => {
    const observer = new PerformanceObserver((list) => {
      if (list.getEntriesByName('first-contentful-paint').length > 0) resolve(observer.disconnect());
    });
    observer.observe({ type: 'paint', buffered: true });
  });
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
