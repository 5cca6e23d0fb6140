/**
 * `.ci/run`: the full check. A failed command does not stop the others. The reports of failures are repeated at the end,
 * because hosts often show only the end of a log; the last line is the sum of the results.
 */

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { root } from './lib/paths.mjs';
import { conclude } from './lib/userError.mjs';
import { failureReports, sumEndings } from './test/tally.mjs';

const COMMANDS = [['test'], ['run', 'test:engines']];

await conclude(async () => {
  const outcomes = [];
  for (const command of COMMANDS) outcomes.push(await npm(command));
  for (const report of outcomes.flatMap(({ output }) => failureReports(output))) console.log(report);
  const { passed, failed } = sumEndings(outcomes);
  console.log(`${passed} passed, ${failed} failed`);
  return failed > 0 ? 1 : 0;
});

/** Runs an npm command. Forwards its output and returns its standard output. */
async function npm(/** @type {string[]} */ command) {
  const child = spawn('npm', command, { cwd: root, stdio: ['ignore', 'pipe', 'inherit'] });
  let output = '';
  child.stdout.setEncoding('utf8').on('data', (text) => {
    output += text;
    process.stdout.write(text);
  });
  const [status] = await once(child, 'close');
  return { status: Number(status ?? 128), output };
}
