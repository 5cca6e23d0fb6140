/** One very moment of the smoke: how it came to be, as a link, and the way back to it. */
import { LONGEST_LEAD } from '../../preset/environment.ts';
import { encode, type State } from '../../preset/codec.ts';
import type { Values } from '../../preset/parameter.ts';
import { linkCapacity, lookOf } from '../../page/moment.ts';
import { STEP_SECONDS } from '../../sim/clock.ts';
import type { Stage } from '../../stage/stage.ts';
import type { Take } from '../../stage/take.ts';
import { enterScene } from '../editor/entering.ts';
import type { Notices } from '../ui/notices.ts';
import { windForward } from '../ui/progress.ts';
import { strings } from '../strings.ts';

/** Nobody waits for more; an hour of the lamp takes about a minute to do again. */
const LONGEST_TAKE_SECONDS = 3600;

/** A moment that somebody shared. */
export interface LinkedMoment {
  readonly take: Uint8Array;
  /** Simulated seconds; the end of the take where left out. */
  readonly seconds?: number;
  /** What style, light and camera were then, which no take keeps by step. */
  readonly state: State;
  /** Whether it may ask for whatever the simulator can hold, as a file of one's own may. */
  readonly isTrusted: boolean;
}

/** The link to what the stage shows now, step for step. It may be longer than anybody wants to send. */
export async function linkToMoment(state: State, stage: Stage): Promise<string> {
  const take = stage.take();
  const { steps, time } = stage.stats;
  // What nobody touched comes to the same by itself, and its link stays short.
  const isUntouched = take.inputs === 0 && take.isFresh && time <= LONGEST_LEAD;
  const address = new URL(location.href);
  setQuery(address, 't', isUntouched || steps !== take.steps ? String(Number(time.toFixed(3))) : undefined);
  setQuery(address, 'paused', stage.playing ? undefined : '1');
  address.hash = await encode(state, isUntouched ? undefined : take.toBytes());
  return address.href;
}

/**
 * Does again what was done in a take, with progress and a way out, and tells where that cannot be.
 * @param container where progress is shown
 * @returns whether it arrived
 */
export async function goToMoment(
  stage: Stage,
  moment: LinkedMoment,
  notices: Notices,
  container: HTMLElement,
): Promise<boolean> {
  try {
    const take = stage.readTake(moment.take);
    const error = moment.isTrusted ? undefined : errorOf(take);
    if (error !== undefined) throw new Error(error);
    if (take.isTruncated) notices.notify(strings.moment.truncated);
    if (!take.isExact) notices.notify(strings.moment.inexact);
    if (take.values.scene !== stage.get().scene) await enterScene(stage, take.values, container);
    stage.playTake(take);
    lookAs(stage, moment.state.values);
    return await wind(stage, moment.seconds ?? take.steps * STEP_SECONDS, notices, container);
  } catch (error) {
    notices.notify(strings.moment.rejected((error as Error).message));
    return false;
  }
}

async function wind(stage: Stage, seconds: number, notices: Notices, container: HTMLElement): Promise<boolean> {
  const goal = Math.min(seconds, LONGEST_TAKE_SECONDS);
  if (goal < seconds) notices.notify(strings.moment.tooLate(goal));
  const hasArrived = await windForward(stage, goal, container, strings.moment.winding);
  if (!hasArrived) notices.mention(strings.progress.cancelled(stage.stats.time));
  return hasArrived;
}

/** Why a take out of an untrusted link is not played; undefined where it is. */
function errorOf({ isFresh, mostParticles }: Take): string | undefined {
  const max = linkCapacity();
  if (!isFresh) return strings.moment.notFresh;
  return mostParticles > max ? strings.moment.tooMany(mostParticles, max) : undefined;
}

/** Gives a stage what the simulator does not read, and so no take keeps by step. */
function lookAs(stage: Stage, values: Values): void {
  const needless = Object.keys(lookOf(stage.get())).filter((key) => values[key] === undefined);
  stage.unset(needless);
  stage.set(lookOf(values));
}

function setQuery(address: URL, name: string, value: string | undefined): void {
  if (value === undefined) address.searchParams.delete(name);
  else address.searchParams.set(name, value);
}
