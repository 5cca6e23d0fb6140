import type { Values } from '../../parameters/parameter.ts';
import { differing } from '../../parameters/values.ts';
import type { RemoteStage } from '../../stage/remote/contract.ts';

/**
 * Applies the differences between two sets of values. All calls are sent at once, so that later calls take effect after
 * them.
 */
export async function change(stage: RemoteStage, before: Values, after: Values): Promise<void> {
  const gone = Object.keys(before).filter((key) => !(key in after));
  const changed = differing(before, after);
  await Promise.all([gone.length > 0 && stage.unset(gone), Object.keys(changed).length > 0 && stage.set(changed)]);
}
