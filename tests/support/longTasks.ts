/** CPU time of the tasks of a page's main thread. */

interface TraceEvent {
  readonly name: string;
  readonly ph: string;
  readonly pid: number;
  readonly tid: number;
  readonly ts: number;
  /** CPU time, microseconds. */
  readonly tdur?: number;
  readonly args?: { readonly name?: string };
}

/** Trace categories for `browser.startTracing`. */
export const TASK_CATEGORIES = ['toplevel', 'blink.user_timing'];

/** CPU time of `work` on the machine that the limits of the tests were measured on, milliseconds. */
const WORK_MS = 28;

function work(): number {
  let state = 1;
  for (let round = 0; round < 20_000_000; round++) state = (Math.imul(state, 1664525) + 1013904223) | 0;
  return state;
}

/** How many times slower this machine is than that one, at least 1. */
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
 * CPU times in milliseconds of a page's main-thread tasks after a mark, longest first. CPU time instead of wall time
 * excludes the load of other processes.
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
