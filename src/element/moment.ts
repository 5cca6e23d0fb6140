import { notice, type Notice } from '../preset/notice.ts';
import type { Values } from '../preset/parameter.ts';
import { linkCapacity, lookOf } from '../page/moment.ts';
import type { RemoteStage } from '../remote/contract.ts';
import { STEP_SECONDS } from '../sim/clock.ts';
import type { Take } from '../stage/take.ts';

/** Nobody waits for more on a page that is about something else. */
const LONGEST_SECONDS = 600;

/**
 * Does again what was done in a take out of a share link.
 * @param seconds where to stop; the end of the take when left out
 * @param values of the link, for what no take keeps: style, light and camera
 * @returns why it was left out, or that it may end differently; nothing otherwise
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
    await stage.set(lookOf(values));
    await stage.seek(Math.min(seconds ?? take.steps * STEP_SECONDS, LONGEST_SECONDS));
    const sentence = () => 'An older version recorded the moment in the link. The smoke may end differently.';
    return take.isExact ? [] : [notice('otherVersion', 'take', '', sentence)];
  } catch (error) {
    const sentence = () => `The moment in the link cannot be shown: ${(error as Error).message}`;
    return [notice('damaged', 'take', '', sentence)];
  }
}

/** @throws Error when an untrusted take asks for more than links may */
function checkCapacity({ isFresh, mostParticles }: Take): void {
  const max = linkCapacity();
  if (!isFresh) throw new Error('it starts from a saved state.');
  if (mostParticles > max) throw new Error(`it needs room for ${mostParticles} particles; the limit is ${max}.`);
}
