import type { Values } from '../preset/parameter.ts';
import type { RemoteStage } from '../remote/contract.ts';

/**
 * Goes from what was wanted before to what is wanted now, by as little as there is between the two. All is sent at once, so that
 * whoever changes something after this comes after all of it.
 */
export async function change(stage: RemoteStage, before: Values, after: Values): Promise<void> {
  const gone = Object.keys(before).filter((key) => !(key in after));
  const changed = Object.entries(after).filter(([key, value]) => before[key] !== value);
  await Promise.all([
    gone.length > 0 && stage.unset(gone),
    changed.length > 0 && stage.set(Object.fromEntries(changed)),
  ]);
}
