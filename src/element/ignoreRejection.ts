/**
 * Lets something run whose failure is told elsewhere, by the stage's own event, or comes of the stage's end: the console
 * of a page is not ours.
 */
export function ignoreRejection(work: Promise<unknown>): void {
  work.catch(() => undefined);
}
