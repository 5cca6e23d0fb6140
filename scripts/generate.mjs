/**
 * `npm run generate`: writes the files that are derived from other sources. The tests that write them fail when a file
 * is stale. Each file depends on the previous ones.
 */

import { readArguments } from './lib/arguments.mjs';
import { runScript } from './lib/command.mjs';
import { withProgress } from './lib/progress.mjs';
import { conclude, UserError } from './lib/userError.mjs';
import { PAGE, setUp } from './setup/setup.mjs';
import { cargoNative } from './setup/toolchain.mjs';

const environment = { GENERATE: '1' };

/** @typedef {(line: string) => void} Say */

/** @type {[file: string, work: (say: Say) => Promise<import('./lib/command.mjs').Outcome>][]} */
const FILES = [
  ['constants in shaders/ and sim-wasm/', (say) => vitest('constants', 'has the shared constants', say)],
  [
    'lists.json, singles.json and words/lists.json in src/parameters, src/simulator/layout.ts',
    (say) => cargoNative('test', ['--test', 'all', 'simulator::page_table'], say, environment),
  ],
  [
    'tests/visual/renderer/passes/volumes/volumes.txt',
    (say) => cargoNative('test', ['--lib', 'coverage::outline'], say, environment),
  ],
  ['src/parameters/valueTypes.ts', (say) => vitest('parameters/valueTypes', 'are those of the table', say)],
  [
    'attributes/names.json and methods.json in src/page/element',
    (say) => vitest('page/element/names', 'npm run generate', say),
  ],
  ['public/smoke-file.schema.json', (say) => vitest('parameters/file', 'equals the file in public/', say)],
  ['tables in docs/', (say) => vitest('repository/documents', 'has the generated table', say)],
];

await conclude(async () => {
  readArguments({}, 'npm run generate');
  await setUp(PAGE);
  for (const [file, work] of FILES) {
    const { status, output } = await withProgress(file, work);
    if (status !== 0) throw new UserError(`${file} could not be written: see the output above.`, output);
  }
  console.log('All generated files are up to date.');
});

/**
 * @param {string} name path in tests/unit, without its ending
 * @param {string} test part of the title
 * @param {Say} say
 */
function vitest(name, test, say) {
  const parameters = ['run', `tests/unit/${name}.test.ts`, '-t', test];
  return runScript('node_modules/vitest/vitest.mjs', parameters, { environment, onLine: say });
}
