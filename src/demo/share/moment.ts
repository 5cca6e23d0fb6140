/** Links to an exact moment of the smoke, and the replay of such links. */
import type { Stage, Take } from '../../index.ts';
import { linkCapacity, LONGEST_LEAD, LONGEST_LINK, lookOf, STEP_SECONDS, type Environment } from '../../internal.ts';
import { encode, type Decoded, type State, type Values } from '../../preset.ts';
import { enterScene, windForward } from '../ui/progress.ts';
import type { Notices } from '../ui/notices.ts';
import { strings } from '../strings.ts';

/** Limit in simulated seconds. Replaying an hour of the lamp takes about a minute. */
const LONGEST_TAKE_SECONDS = 3600;

/** A shared moment. */
export interface LinkedMoment {
  readonly take: Uint8Array;
  /** Simulated seconds; defaults to the end of the take. */
  readonly seconds?: number;
  /** Style, light and camera at the moment. */
  readonly state: State;
  /** Whether it may request the simulator's full capacity, as a local file may. */
  readonly isTrusted: boolean;
}

/** The moment of a link, if it has one. */
export function momentOf({ take, state }: Decoded, environment?: Environment): LinkedMoment | undefined {
  return take && { take, state, seconds: environment?.time, isTrusted: false };
}

/** The link to the exact current step of the stage. It may be too long to send. */
export async function linkToMoment(state: State, stage: Stage): Promise<string> {
  const take = stage.take();
  const { steps, time } = stage.stats;
  // Smoke without input is reproducible from its parameters, which keeps the link short.
  const isLookFixed = take.changed.length === 0 || !state.values.timeline;
  const isUntouched = take.inputs === 0 && isLookFixed && take.isFresh && time <= LONGEST_LEAD;
  const address = new URL(location.href);
  setQuery(address, 't', isUntouched || steps !== take.steps ? String(Number(time.toFixed(3))) : undefined);
  setQuery(address, 'paused', stage.playing ? undefined : '1');
  address.hash = await encode(state, isUntouched ? undefined : take.toBytes());
  // Without the changes of the look, the link has the last one from the start.
  if (address.href.length > LONGEST_LINK && !isUntouched)
    address.hash = await encode(state, stage.take({ look: false }).toBytes());
  return address.href;
}

/**
 * Replays a take, with progress and a cancel button, and reports failures.
 * @param container parent of the progress bar
 * @returns whether it reached the moment
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
    if (take.values.scene !== stage.get().scene) await enterScene(stage, take.values, container);
    stage.playTake(take);
    lookAs(stage, moment.state.values, take);
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

/** Why a take from an untrusted link is rejected; undefined when it is accepted. */
function errorOf({ isFresh, mostParticles }: Take): string | undefined {
  const max = linkCapacity();
  if (!isFresh) return strings.moment.notFresh;
  return mostParticles > max ? strings.moment.tooMany(mostParticles, max) : undefined;
}

/** Applies the values of style, light and camera that the take does not change over time. */
function lookAs(stage: Stage, values: Values, take: Take): void {
  const needless = Object.keys(lookOf(stage.get(), take)).filter((key) => !(key in values));
  stage.unset(needless);
  stage.set(lookOf(values, take));
}

function setQuery(address: URL, name: string, value: string | undefined): void {
  if (value === undefined) address.searchParams.delete(name);
  else address.searchParams.set(name, value);
}
