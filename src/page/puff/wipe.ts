/** The smoke of `puff.wipe()`: it covers the page or an element at one known step, and clears afterwards. */
import { ContextError, LoadError } from '../../base/errors.ts';
import type { RemoteStage } from '../../stage/remote/contract.ts';
import { openStage } from '../../stage/remote/openStage.ts';
import { asSmokeError } from '../asSmokeError.ts';
import { sizeOf } from '../size.ts';
import { Cover } from './cover.ts';
import { hexOf, lookOf } from './look.ts';
import type { WipeOptions } from './options.ts';
import type { Source } from './target.ts';
import { clearedAfter, makeWipe, type Wipe } from './wipeSmoke.ts';

/** The worker presents the empty picture before it ends, milliseconds. */
const GRACE_MS = 1000;
/** Frames of the page until it shows what the worker drew last. */
const FRAMES = 3;
/** Interval in which the simulated time is read near the end of a wait, milliseconds. */
const MIN_INTERVAL_MS = 30;

/**
 * Covers the target with smoke, changes the page while everything is covered, and clears the smoke.
 * @param source the page if absent
 * @param change called once
 * @param signal removes the smoke at once
 * @returns resolves when the smoke is gone
 * @throws UnsupportedError, LoadError or ContextError when smoke cannot be drawn
 */
export async function playWipe(
  source: Source | undefined,
  options: WipeOptions,
  change: () => Promise<void>,
  signal: AbortSignal,
): Promise<void> {
  const cover = new Cover(source, options.zIndex);
  let stage: RemoteStage | undefined;
  try {
    const { duration = 0.9, direction = 0, color, seed = Math.floor(Math.random() * 2 ** 32) } = options;
    const look = await lookOf(options.preset);
    const tint = color === undefined ? undefined : hexOf(color, source?.inside);
    const size = sizeOf(cover.canvas);
    const { values, emissions } = makeWipe(look, size, { direction, duration, seed }, tint);
    const opened = { values, ...size, quality: 'auto', background: false, historyBytes: 0, graceMs: GRACE_MS } as const;
    stage = await openStage(() => cover.makeCanvas(), { ...opened, signal });
    const failure = failureOf(stage, signal);
    await Promise.race([failure, play(stage, emissions, duration, change, cover)]);
  } catch (error) {
    if (!signal.aborted) throw asSmokeError(error);
  } finally {
    stage?.dispose().catch(() => undefined);
    cover.remove();
  }
}

async function play(
  stage: RemoteStage,
  emissions: Wipe['emissions'],
  duration: number,
  change: () => Promise<void>,
  cover: Cover,
): Promise<void> {
  await Promise.all(emissions.map((each) => stage.emit(each)));
  await stage.play();
  await reached(stage, duration);
  await stage.pause();
  // Exactly this step, back or forth: the same picture on every machine.
  await stage.seek(duration);
  await pageShown();
  // The caller reports its failure; the smoke clears nevertheless.
  await change().catch(() => undefined);
  cover.place();
  await pageShown();
  await stage.play();
  await reached(stage, duration + clearedAfter(duration));
}

/** Rejects when the stage fails, or is no longer wanted. */
function failureOf(stage: RemoteStage, signal: AbortSignal): Promise<never> {
  return new Promise((_, reject) => {
    stage.on('error', (error) => {
      // The stage goes on without what could not be fetched.
      if (!(error instanceof LoadError)) reject(error);
    });
    signal.addEventListener('abort', () => reject(new ContextError('The wipe was cancelled.')));
  });
}

/** Resolves when the simulation has reached a time. */
async function reached(stage: RemoteStage, time: number): Promise<void> {
  for (;;) {
    const { time: now } = await stage.stats();
    if (now >= time) return;
    await new Promise((resolve) => setTimeout(resolve, Math.max(MIN_INTERVAL_MS, 1000 * (time - now))));
  }
}

/** Resolves when the page has the latest picture. In a hidden tab it never does, and the wipe ends. */
async function pageShown(): Promise<void> {
  for (let frame = 0; frame < FRAMES; ++frame) await new Promise(requestAnimationFrame);
}
