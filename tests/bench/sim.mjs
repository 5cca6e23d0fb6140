/**
 * `npm run bench -- sim`: cost of a step, compared with native code, JavaScript, a pass over memory, and two particle
 * engines; and our collisions compared with Rapier's queries.
 */

import { costsTable } from './sim/costsTable.mjs';
import { buildContestants, Native } from './sim/native.mjs';
import { buildMeasuringModule } from './sim/collide/measuringModule.mjs';
import { measureInPage } from './support/page.mjs';

/** @param {import('./support/page.mjs').Choice} choice */
export async function run(choice) {
  await buildContestants(choice.say);
  await buildMeasuringModule(choice.say);
  const native = new Native();
  try {
    return await measureInPage('/tests/bench/sim/suite.ts', choice, [native.plugin()]);
  } finally {
    native.stop();
  }
}

export { costsTable as summary };
