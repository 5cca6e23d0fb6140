/** `npm run bench -- sim`: a step of ours against the same step in JavaScript, and our collisions against Rapier's queries. */

import { measureInPage } from './support/page.mjs';

/** @param {import('./support/page.mjs').Choice} choice */
export function run(choice) {
  return measureInPage('/tests/bench/sim/suite.ts', choice);
}
