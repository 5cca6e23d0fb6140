/** The test suites. Each runs its own test runner and counts the results in the runner's machine-readable report. */

import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { runScript } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';
import { filesUnder } from '../setup/sources.mjs';
import { cargoNative } from '../setup/toolchain.mjs';
import { notesIn, readReport, settle, tallyCargo, tallyPlaywright, tallyVitest } from './tally.mjs';

/**
 * @typedef {import('./checks.mjs').Runner} Runner
 * @typedef {import('./checks.mjs').Say} Say
 * @typedef {object} Choice
 * @property {boolean} long only the long tests, which are skipped otherwise
 * @property {boolean} engines only the tests for three browser engines
 * @property {boolean} update rewrite the goldens instead of comparing with them
 */

/**
 * The suites in execution order.
 * @type {(choice: Choice) => Runner[]}
 */
export function suites(choice) {
  if (choice.engines) return [engines];
  const all = [rust(choice), unit(choice), browser(choice)];
  return choice.long ? all.filter((suite) => hasLongTests(suite.name)) : all;
}

const REPORTS = '.cache/test';

/**
 * The simulator is tested only with the `rigids` feature. The variant without it compiles a subset of the same code,
 * and the unit tests run it as WASM and compare hashes.
 *
 * @type {(choice: Choice) => Runner}
 */
function rust({ long }) {
  // No examples, because the lint compiles them, and no doctests, because there are none.
  const targets = ['--no-fail-fast', '--lib', '--bins', '--tests'];
  return {
    name: 'rust',
    title: 'Rust tests',
    lane: 'cargo',
    run: async (say) => {
      // Optimised physics saves the long tests more time than it takes to compile.
      const [filter, environment] = long
        ? [['--', '--ignored'], { CARGO_PROFILE_DEV_OPT_LEVEL: '1' }]
        : [[], undefined];
      const { status, output } = await cargoNative('test', [...targets, ...filter], say, environment);
      return { ...settle(tallyCargo(output), status), output };
    },
  };
}

/** @type {(choice: Choice) => Runner} */
function unit({ long }) {
  return {
    name: 'unit',
    title: 'Unit tests (vitest)',
    // The long browser tests run alone.
    lane: long ? undefined : 'unit',
    run: (say) => vitest('unit.json', [], { TEST_LONG: long ? '1' : '' }, say),
  };
}

/** @type {Runner} */
const engines = {
  name: 'engines',
  title: 'Browser engines (vitest)',
  run: (say) => vitest('engines.json', ['--config', 'tests/engines/vitest.config.ts'], {}, say),
};

/**
 * @param {string} name
 * @param {string[]} choice
 * @param {NodeJS.ProcessEnv} environment
 * @param {Say} say
 */
async function vitest(name, choice, environment, say) {
  const report = freshReport(name);
  const parameters = ['run', ...choice, '--reporter=default', '--reporter=json', `--outputFile.json=${report}`];
  const options = { environment, onLine: say };
  const { status, output } = await runScript('node_modules/vitest/vitest.mjs', parameters, options);
  const json = readReport(report);
  return { ...settle(json && tallyVitest(json), status), output, notes: json ? notesIn(json) : [] };
}

/** @type {(choice: Choice) => Runner} */
function browser({ long, update }) {
  return {
    name: 'browser',
    title: 'Browser tests (Playwright)',
    run: async (say) => {
      const report = freshReport('browser.json');
      const { status, output } = await runScript(
        'node_modules/@playwright/test/cli.js',
        ['test', '--reporter=list,json'],
        {
          environment: {
            TEST_LONG: long ? '1' : '',
            UPDATE_GOLDENS: update ? '1' : '',
            PLAYWRIGHT_JSON_OUTPUT_FILE: report,
          },
          onLine: say,
        },
      );
      const json = readReport(report);
      return { ...settle(json && tallyPlaywright(json), status), output };
    },
  };
}

/** Path for a runner's report. Removes the previous report, so that it cannot hide a crash. */
function freshReport(/** @type {string} */ name) {
  mkdirSync(inRoot(REPORTS), { recursive: true });
  const path = inRoot(`${REPORTS}/${name}`);
  rmSync(path, { force: true });
  return path;
}

function hasLongTests(/** @type {string} */ name) {
  if (name === 'rust') {
    return filesUnder('sim-wasm/sim').some(
      (path) => path.endsWith('.rs') && readFileSync(inRoot(path), 'utf8').includes('#[ignore'),
    );
  }
  const isLong = name === 'unit' ? /^tests\/unit\/.+\.long\.test\.ts$/ : /^tests\/(?!unit\/).+\.long\.(spec|test)\.ts$/;
  return filesUnder('tests').some((path) => isLong.test(path));
}
