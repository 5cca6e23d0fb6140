/** The simulator's WASM with calls that measure; cargo itself knows whether there is anything to build. */

import { Refusal } from '../../../scripts/lib/refusal.mjs';
import { cargo } from '../../../scripts/setup/toolchain.mjs';

/** @param {(line: string) => void} say */
export async function buildMeasuringModule(say) {
  const xtask = ['run', '--locked', '--package', 'xtask', '--profile', 'xtask', '--', 'wasm', '--bench'];
  const { status, output } = await cargo(xtask, say);
  if (status !== 0) throw new Refusal('The measuring module does not compile: see the lines above.', output);
}
