/** `npm run bench -- render`: what the passes of a frame cost, with and without culling, and what memory smoke takes. */

import { measureInPage } from './support/page.mjs';

/** @param {import('./support/page.mjs').Choice} choice */
export function run(choice) {
  return measureInPage('/tests/bench/render/suite.ts', choice);
}
