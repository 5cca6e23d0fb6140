import { notice, type Notice } from '../../parameters/notice.ts';
import type { Values } from '../../parameters/parameter.ts';
import type { RemoteStage } from '../../stage/remote/contract.ts';
import { STEP_SECONDS } from '../../simulator/clock.ts';
import type { Take } from '../../stage/take.ts';
import { findParameter } from '../../parameters/table.ts';
import { isOfLookStyle } from '../../simulator/lookStyles.ts';

/** Limit for pages on which smoke is a side feature. */
const LONGEST_SECONDS = 600;

/**
 * Replays a take from a share link.
 * @param seconds where to stop; defaults to the end of the take
 * @param values of the link for style, light and camera as far as the take does not change them
 * @returns a notice when the take is ignored; otherwise none
 */
export async function goToMoment(
  stage: RemoteStage,
  bytes: Uint8Array,
  seconds: number | undefined,
  values: Values,
): Promise<Notice[]> {
  try {
    const take = await stage.readTake(bytes);
    checkCapacity(take);
    if (take.values.scene !== values.scene) await stage.enter(take.values);
    await stage.playTake(bytes);
    await stage.set(lookOf(values, take));
    await stage.seek(Math.min(seconds ?? take.steps * STEP_SECONDS, LONGEST_SECONDS));
    return [];
  } catch (error) {
    const sentence = () => `The moment in the link cannot be shown: ${(error as Error).message}`;
    return [notice('damaged', 'take', '', sentence)];
  }
}

/** @throws Error when an untrusted take exceeds the limits of links */
function checkCapacity({ isFresh, mostParticles }: Take): void {
  const max = linkCapacity();
  if (!isFresh) throw new Error('it starts from a saved state.');
  if (mostParticles > max) throw new Error(`it needs room for ${mostParticles} particles. The limit is ${max}.`);
}

/** Maximum particle capacity that a take from a link may request. */
export function linkCapacity(): number {
  const row = findParameter('simulation.maxParticles');
  return row?.kind === 'integer' ? (row.linkMax ?? row.max) : 0;
}

/**
 * Values for style, light and camera. The simulator does not read them, so takes do not record them per step. The colours
 * of emitters' looks are those of the take: a change would be an input, which ends the replay.
 * @param take that changes some of them over time, itself or by its timeline; these are left out
 */
export function lookOf(values: Values, take?: Pick<Take, 'changed' | 'values'>): Values {
  const isLook = (key: string) =>
    ['style', 'light', 'camera'].includes(findParameter(key)!.reader) && !isOfLookStyle(key);
  const lanes = (take?.values.timeline ?? '').split(';').map((lane) => lane.split('/', 1)[0]);
  const moving = new Set([...lanes, ...(take?.changed ?? [])]);
  return Object.fromEntries(Object.entries(values).filter(([key]) => isLook(key) && !moving.has(key)));
}
