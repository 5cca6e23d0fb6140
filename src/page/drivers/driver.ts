/**
 * Drivers: values from 0 to 1 that change parameters while smoke plays, by `set`, as a hand does. Takes record the changes
 * and not their source, so that a recorded performance replays to the bit.
 */
import { ParameterError } from '../../base/errors.ts';
import type { Value, Values } from '../../parameters/parameter.ts';
import type { Lane } from '../../parameters/timeline.ts';
import { differing } from '../../parameters/values.ts';
import { LEVELS, valuesOf } from './ranges.ts';

/** A `Stage`, a `CartoonSmoke`, a `RemoteStage` or an element `<cartoon-smoke>`. */
export interface DrivenSmoke {
  set(values: Values): unknown;
  readonly stats: { readonly steps: number } | (() => Promise<{ readonly steps: number }>);
}

/** Changes parameters until it is stopped. */
export interface Driver {
  /** The parameters stay as they are. Can be called more than once. */
  stop(): void;
}

export interface DriverOptions {
  /** Seconds in which a driver covers 63 % of the way to a new value, 0 to 10. */
  smoothing?: number;
  /** Stops the driver. */
  signal?: AbortSignal;
  /** Receives the error of a `set` that fails later, which stops the driver. Default: the page's event `error`. */
  onError?: (error: unknown) => void;
}

/** What a driver follows. */
export interface Source {
  /** The parameters of each of its values. */
  readonly tracks: readonly (readonly Lane[])[];
  /** Whether it is a control that a person sets, which also works with reduced motion. */
  readonly isControl?: boolean;
  /** Whether it changes without calling `wake`. */
  isLive?(): boolean;
  /**
   * Starts.
   * @param wake calls for a frame. Returns false where the person asks for reduced motion
   * @param signal of the end
   * @param fail stops the driver and reports an error
   */
  start(wake: () => boolean, signal: AbortSignal, fail: (error: unknown) => void): void;
  /**
   * Its values from 0 to 1, one for each track; undefined where there is none yet.
   * @param seconds since the last call, at least 0.001
   */
  measure(seconds: number): readonly (number | undefined)[];
}

/** Names of the options that all drivers have. */
export const OPTIONS = ['smoothing', 'signal', 'onError'] as const;
const REDUCED_MOTION = '(prefers-reduced-motion: reduce)';
const MAX_SMOOTHING = 10;
/** Of the first frame. */
const FRAME_SECONDS = 1 / 60;
/** A longer frame, as after the tab was hidden, counts as this. */
const LONGEST_SECONDS = 0.1;

/** @throws ParameterError unless it is a number in this range */
export function requireInRange(name: string, value: unknown, min: number, max: number, unit: string): void {
  if (typeof value !== 'number' || !(value >= min && value <= max))
    throw new ParameterError(name, value, `a number from ${min} to ${max} ${unit}`);
}

/** @throws ParameterError for what is no smoke and for an invalid option that all drivers have */
export function requireDriver(smoke: unknown, { smoothing, signal, onError }: DriverOptions): void {
  if (typeof (smoke as DrivenSmoke | null | undefined)?.set !== 'function')
    throw new ParameterError('smoke', smoke, 'a Stage, a CartoonSmoke, a RemoteStage or an element <cartoon-smoke>');
  if (smoothing !== undefined) requireInRange('smoothing', smoothing, 0, MAX_SMOOTHING, 's');
  if (signal !== undefined && !(signal instanceof AbortSignal))
    throw new ParameterError('signal', signal, 'an AbortSignal');
  if (onError !== undefined && typeof onError !== 'function')
    throw new ParameterError('onError', onError, 'a function');
}

/**
 * Starts a driver. The first values are set at once.
 * @throws as {@link requireDriver}, and what `set` throws
 */
export function drive(smoke: DrivenSmoke, source: Source, options: DriverOptions): Driver {
  requireDriver(smoke, options);
  const { smoothing = 0, signal, onError = (error) => reportError(error) } = options;
  const loop = new DriverLoop(smoke, source, smoothing, onError);
  if (!signal?.aborted) loop.start(signal);
  return { stop: () => loop.stop() };
}

/** Follows a source frame by frame while it changes, and changes the smoke at most once a step. */
class DriverLoop {
  private readonly smoke: DrivenSmoke;
  private readonly source: Source;
  private readonly smoothing: number;
  private readonly report: (error: unknown) => void;
  private readonly end = new AbortController();
  private readonly reducedMotion = matchMedia(REDUCED_MOTION);
  /** The smoothed value of each track. */
  private readonly smoothed: (number | undefined)[] = [];
  private sent: Readonly<Record<string, Value>> = {};
  /** The step of the last change. */
  private step: number | undefined;
  /** Answers of the smoke that are not there yet. */
  private waits = 0;
  private frame: number | undefined;
  /** When the last frame was, in milliseconds; undefined after a pause. */
  private last: number | undefined;

  constructor(smoke: DrivenSmoke, source: Source, smoothing: number, report: (error: unknown) => void) {
    this.smoke = smoke;
    this.source = source;
    this.smoothing = smoothing;
    this.report = report;
  }

  start(until: AbortSignal | undefined): void {
    const { signal } = this.end;
    until?.addEventListener('abort', () => this.stop(), { signal });
    this.reducedMotion.addEventListener('change', () => this.wake(), { signal });
    try {
      this.source.start(
        () => this.wake(),
        signal,
        (error) => this.fail(error),
      );
      this.follow(FRAME_SECONDS);
    } catch (error) {
      this.stop();
      throw error;
    }
    this.wake();
  }

  stop(): void {
    this.end.abort();
    if (this.frame !== undefined) cancelAnimationFrame(this.frame);
    this.frame = undefined;
  }

  private get isPaused(): boolean {
    return this.end.signal.aborted || (!this.source.isControl && this.reducedMotion.matches);
  }

  private wake(): boolean {
    if (this.isPaused) return false;
    this.frame ??= requestAnimationFrame((now) => this.tick(now));
    return true;
  }

  private fail(error: unknown): void {
    if (this.end.signal.aborted) return;
    this.stop();
    this.report(error);
  }

  private tick(now: number): void {
    this.frame = undefined;
    if (this.isPaused) return;
    const seconds = this.last === undefined ? FRAME_SECONDS : (now - this.last) / 1000;
    this.last = undefined;
    try {
      const hasSettled = this.follow(Math.min(Math.max(seconds, 0.001), LONGEST_SECONDS));
      if (hasSettled && !this.source.isLive?.()) return;
    } catch (error) {
      this.fail(error);
    }
    if (this.wake()) this.last = now;
  }

  /** @returns whether nothing changes any more until the source does */
  private follow(seconds: number): boolean {
    const targets = this.source.measure(seconds).map((target) => (target === undefined ? target : clamped(target)));
    for (const [track, target] of targets.entries())
      this.smoothed[track] = this.approached(this.smoothed[track], target, seconds);
    const isReached = targets.every((target, track) => this.smoothed[track] === target);
    return this.send() && isReached;
  }

  private approached(value: number | undefined, target: number | undefined, seconds: number): number | undefined {
    if (value === undefined || target === undefined) return target;
    const next = value + ((target - value) * seconds) / (seconds + this.smoothing);
    return Math.abs(target - next) < 0.5 / LEVELS ? target : next;
  }

  /** Values that the smoke has not yet. */
  private get changed(): Values {
    const all = this.source.tracks.map((lanes, track) => {
      const value = this.smoothed[track];
      return value === undefined ? {} : valuesOf(lanes, Math.round(value * LEVELS));
    });
    return differing(this.sent, Object.assign({}, ...all));
  }

  /** @returns whether the smoke has all values */
  private send(): boolean {
    if (Object.keys(this.changed).length === 0) return true;
    if (this.waits > 0) return false;
    const { smoke } = this;
    const stats = typeof smoke.stats === 'function' ? smoke.stats.call(smoke) : smoke.stats;
    if (!(stats instanceof Promise)) return this.set(stats);
    this.wait(stats.then((remote) => this.set(remote)));
    return false;
  }

  private set({ steps }: { readonly steps: number }): boolean {
    if (this.end.signal.aborted || steps === this.step) return false;
    const { changed } = this;
    this.step = steps;
    this.sent = { ...this.sent, ...changed };
    const answer = this.smoke.set(changed);
    if (answer instanceof Promise) this.wait(answer);
    return true;
  }

  /** Nothing is sent before an answer, so that calls do not pile up. */
  private wait(answer: Promise<unknown>): void {
    ++this.waits;
    answer.then(
      () => --this.waits,
      (error: unknown) => this.fail(error),
    );
  }
}

/** NaN, as of a page that cannot scroll, is 0. */
function clamped(value: number): number {
  return value > 0 ? Math.min(value, 1) : 0;
}
