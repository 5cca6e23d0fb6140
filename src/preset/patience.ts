/** What is fetched and of which nothing comes for so long does not come. */
export const PATIENCE_MS = 60_000;

const TICK_MS = 1_000;

/**
 * Calls back once this thread has run for so long. A laptop that slept, a tab whose timers rest and a debugger's break make
 * one tick late and not many of them, so that nobody is given up for a time in which nothing could happen.
 * @param milliseconds rounded up to whole seconds
 * @returns the function that ends the waiting
 */
export function afterRunning(milliseconds: number, act: () => void): () => void {
  let left = Math.ceil(milliseconds / TICK_MS);
  const end = () => clearInterval(timer);
  const timer = setInterval(() => {
    left -= 1;
    if (left > 0) return;
    end();
    act();
  }, TICK_MS);
  return end;
}
