/** The simulator's WASM with measuring functions; cargo detects whether a build is needed. */

import { UserError } from '../../../../scripts/lib/userError.mjs';
import { cargo } from '../../../../scripts/setup/toolchain.mjs';

/** @param {(line: string) => void} say */
export async function buildMeasuringModule(say) {
  const xtask = ['run', '--locked', '--package', 'xtask', '--profile', 'xtask', '--', 'wasm', '--bench'];
  const { status, output } = await cargo(xtask, say);
  if (status !== 0) throw new UserError('The measuring module does not compile: see the lines above.', output);
}
