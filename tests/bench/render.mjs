/** `npm run bench -- render`: cost of the passes of a frame, with and without culling, and memory per particle. */

import { measureInPage } from './support/page.mjs';

/** @param {import('./support/page.mjs').Choice} choice */
export function run(choice) {
  return measureInPage('/tests/bench/render/suite.ts', choice);
}
