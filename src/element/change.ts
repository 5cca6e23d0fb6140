import type { Values } from '../preset/parameter.ts';
import type { RemoteStage } from '../remote/contract.ts';

/** Goes from what was wanted before to what is wanted now, by as little as there is between the two. */
export async function change(stage: RemoteStage, before: Values, after: Values): Promise<void> {
  const gone = Object.keys(before).filter((key) => !(key in after));
  const changed = Object.entries(after).filter(([key, value]) => before[key] !== value);
  if (gone.length > 0) await stage.unset(gone);
  if (changed.length > 0) await stage.set(Object.fromEntries(changed));
}
