/** Checks without a test runner. Each counts as one test that passes or fails. */

import { runScript } from '../lib/command.mjs';
import { UserError } from '../lib/userError.mjs';
import { packages as docsPackages } from '../setup/docs.mjs';
import { cargo, cargoNative } from '../setup/toolchain.mjs';
import { compileCodeBlocks } from './codeBlocks.mjs';

/**
 * @typedef {import('../lib/command.mjs').Outcome} Outcome
 * @typedef {import('./tally.mjs').Tally & { output: string, trouble?: string, notes?: string[] }} Result notes are
 * shown
 * @typedef {(line: string) => void} Say
 * @typedef {object} Runner
 * @property {string} name the NAME in `npm test -- NAME`
 * @property {string} title
 * @property {'cargo' | 'unit' | undefined} [lane] runners of one lane run in sequence, as cargo locks its build folder
 * anyway; `unit` follows `cargo`
 * @property {(say: Say) => Promise<Result>} run
 */

/** Runs a tool from node_modules. */
function tool(/** @type {string} */ path, /** @type {string[]} */ parameters, /** @type {Say} */ say) {
  return runScript(`node_modules/${path}`, parameters, { onLine: say });
}

/** @type {(name: string, title: string, work: (say: Say) => Promise<Outcome>, lane?: 'cargo') => Runner} */
function check(name, title, work, lane) {
  return {
    name,
    title,
    lane,
    run: async (say) => {
      const { status, output } = await work(say);
      return { passed: status === 0 ? 1 : 0, failed: status === 0 ? 0 : 1, skipped: 0, output };
    },
  };
}

/** @type {(name: string, title: string, work: (say: Say) => Promise<Outcome>) => Runner} */
function checkOfCargo(name, title, work) {
  return check(name, title, work, 'cargo');
}

/** By content, because a checkout changes times. Prettier without a cache deletes one at the default path. */
const CACHE = ['--cache', '--cache-strategy=content', '--cache-location=node_modules/.cache/format.json'];
const OXLINT = 'oxlint/bin/oxlint';
const TSC = 'typescript/bin/tsc';

/** @type {Runner[]} */
export const CHECKS = [
  check('lint', 'Lint (oxlint)', (say) => requireFiles(tool(OXLINT, ['--type-aware', '--deny-warnings'], say))),
  check('format', 'Format (prettier)', (say) => tool('prettier/bin/prettier.cjs', ['--check', '.', ...CACHE], say)),
  check('rustfmt', 'Format (cargo fmt)', (say) => cargo(['fmt', '--all', '--check'], say)),
  checkOfCargo('clippy', 'Build and lint (clippy)', (say) =>
    requireNoWarning(cargoNative('build', ['--all-targets'], say)),
  ),
  check('types', 'Types (tsc)', (say) => tool(TSC, ['--noEmit'], say)),
  check('scripts', 'Types of scripts/ (tsc)', (say) => tool(TSC, ['--noEmit', '-p', 'scripts'], say)),
  check('examples', 'Types of examples/ (tsc)', (say) => tool(TSC, ['--noEmit', '-p', 'examples'], say)),
  check('site', 'Types of site/ (tsc)', typesOfSite),
  check('documents', 'Code in the documents (tsc)', compileCodeBlocks),
  check('arrows', 'Import direction and cycles', (say) => runScript('scripts/lint/imports.mjs', [], { onLine: say })),
];

/**
 * Only the long run lints and tests xtask, because compiling its dependencies takes a minute.
 *
 * @type {Runner[]}
 */
export const LONG_CHECKS = [
  checkOfCargo('clippy-xtask', 'Lint of xtask (cargo clippy)', (say) =>
    cargo(['clippy', '--locked', '--all-targets', '--package', 'xtask', '--', '-D', 'warnings'], say),
  ),
  checkOfCargo('xtask', 'Tests of xtask (cargo test)', (say) =>
    cargo(['test', '--locked', '--package', 'xtask', '--profile', 'xtask'], say),
  ),
  check('fuzz', 'A minute of fuzzing', (say) => fuzz([], say)),
  check('fuzz-rigids', 'A minute of fuzzing with rigids', (say) => fuzz(['--rigids'], say)),
];

/** Fails without the packages of the site, which other checks do not need. */
async function typesOfSite(/** @type {Say} */ say) {
  try {
    if (!docsPackages.isFresh()) await docsPackages.bring(say);
  } catch (error) {
    if (error instanceof UserError) return { status: 1, output: error.message };
    throw error;
  }
  return tool(TSC, ['--noEmit', '-p', 'site'], say);
}

/**
 * @param {string[]} choice
 * @param {Say} say
 */
function fuzz(choice, say) {
  return runScript('scripts/fuzz.mjs', ['--minutes', '1', ...choice], { onLine: say });
}

/** Fails if the compiler warned. Cargo repeats the warnings of crates that it does not compile again. */
async function requireNoWarning(/** @type {Promise<Outcome>} */ pending) {
  const { status, output } = await pending;
  return { status: /^warning:/m.test(output) ? 1 : status, output };
}

/** Fails if the linter checked no files. */
async function requireFiles(/** @type {Promise<Outcome>} */ pending) {
  const { status, output } = await pending;
  const looked = /Finished in .* on (\d+) files?/.exec(output);
  if (status === 0 && !Number(looked?.[1])) return { status: 1, output: `${output}\nNo file was looked at.` };
  return { status, output };
}
