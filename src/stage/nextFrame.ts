/** The screen's next frame, on pages and in workers. */

const INTERVAL_MS = 1000 / 60;

/** Some browsers give workers a canvas but no frames; a timer stands in for them. */
export function requestFrame(callback: (now: number) => void): number {
  if ('requestAnimationFrame' in globalThis) return requestAnimationFrame(callback);
  const now = performance.now();
  return Number(setTimeout(() => callback(performance.now()), INTERVAL_MS - (now % INTERVAL_MS)));
}

export function cancelFrame(request: number): void {
  if ('cancelAnimationFrame' in globalThis) cancelAnimationFrame(request);
  else clearTimeout(request);
}
