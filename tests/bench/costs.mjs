/** `npm run bench -- costs`: what puffs, pixels, objects, composers and styles cost, over a frame with 2,000 puffs. */

import { graphicsFlags } from '../../scripts/lib/chromium.mjs';
import { measureInPage } from './support/page.mjs';

/** With the graphics that $CHROMIUM_ANGLE names, as `npm run bench -- gpu`. @param {import('./support/page.mjs').Choice} choice */
export function run(choice) {
  return measureInPage('/tests/bench/render/costs.ts', choice, [], graphicsFlags(process.env.CHROMIUM_ANGLE));
}
