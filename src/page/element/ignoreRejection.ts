/**
 * Marks a rejection as handled, for work whose failure is reported elsewhere (by the stage's `error` event) or follows
 * from disposal. The library does not write to the page's console.
 */
export function ignoreRejection(work: Promise<unknown>): void {
  work.catch(() => undefined);
}
