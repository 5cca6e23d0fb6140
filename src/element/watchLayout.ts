/** What moves without an event of its own is found so late. */
const LOOK_MS = 400;

/**
 * Calls back when things on a page may have moved against each other: scrolling, sizes, pictures that have come, and now
 * and then while the frame is in view. It may call back although nothing moved.
 * @returns the function that ends it
 */
export function watchLayout(frame: Element, look: () => void): () => void {
  const end = new AbortController();
  const options = { capture: true, passive: true, signal: end.signal } as const;
  const page = frame.ownerDocument;
  for (const type of ['scroll', 'load', 'transitionend', 'animationend']) page.addEventListener(type, look, options);
  page.defaultView?.addEventListener('resize', look, options);
  const sizes = new ResizeObserver(look);
  sizes.observe(frame);
  sizes.observe(page.documentElement);
  let timer: ReturnType<typeof setInterval> | undefined;
  const inView = new IntersectionObserver((entries) => {
    clearInterval(timer);
    if (entries[entries.length - 1].isIntersecting) timer = setInterval(look, LOOK_MS);
  });
  inView.observe(frame);
  return () => {
    end.abort();
    sizes.disconnect();
    inView.disconnect();
    clearInterval(timer);
  };
}
