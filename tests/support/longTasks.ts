/** How long the main thread of a page was busy, task by task. */

interface TraceEvent {
  readonly name: string;
  readonly ph: string;
  readonly pid: number;
  readonly tid: number;
  readonly ts: number;
  /** Microseconds of the processor. */
  readonly tdur?: number;
  readonly args?: { readonly name?: string };
}

/** What `browser.startTracing` has to record. */
export const TASK_CATEGORIES = ['toplevel', 'blink.user_timing'];

/** What `work` takes of a processor on which the limits of the tests were found to hold with room to spare. */
const WORK_MS = 28;

function work(): number {
  let state = 1;
  for (let round = 0; round < 20_000_000; round++) state = (Math.imul(state, 1664525) + 1013904223) | 0;
  return state;
}

/** How many times as long as there this processor takes for the same work, at least 1. */
export function slowness(): number {
  const times = [1, 2, 3, 4].map(() => {
    const before = process.cpuUsage();
    work();
    const { user, system } = process.cpuUsage(before);
    return (user + system) / 1000;
  });
  return Math.max(1, Math.min(...times) / WORK_MS);
}

/**
 * Milliseconds that the tasks of a page's main thread took of the processor after it marked a moment, the longest first.
 * The processor's time and not the clock's: on a busy machine others' work would count as well.
 * @param mark name of a performance.mark that the page made
 */
export function tasksAfter(mark: string, trace: Buffer): number[] {
  const { traceEvents } = JSON.parse(trace.toString()) as { traceEvents: TraceEvent[] };
  const start = traceEvents.find(({ name }) => name === mark);
  if (!start) throw new Error(`The page made no mark ${mark}.`);
  return traceEvents
    .filter(({ ph, pid, tid, ts }) => ph === 'X' && pid === start.pid && tid === start.tid && ts > start.ts)
    .map(({ tdur = 0 }) => tdur / 1000)
    .toSorted((a, b) => b - a);
}
