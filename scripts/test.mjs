/**
 * `npm test [-- [--update] NAME...]`: sets up missing components and runs all checks and test suites, or the named
 * ones. `--long` runs only the long checks and tests, `--engines` only the tests for three browser engines, and
 * `--update` rewrites the screenshot goldens.
 *
 * A failure does not stop the others. The last line is `N passed, N failed`. Cargo's checks and tests do not need the
 * WASM build, so they run in parallel with it and with everything else: cargo often compiles one crate at a time on one
 * core. The unit tests follow them, in parallel with the browser tests, which do not always use two cores.
 */

import { readArguments } from './lib/arguments.mjs';
import { stopPrograms } from './lib/command.mjs';
import { withProgress } from './lib/progress.mjs';
import { conclude, UserError } from './lib/userError.mjs';
import { ENGINES } from './setup/engines.mjs';
import * as npmPackage from './setup/package.mjs';
import { setUp, TOOLCHAIN, TOOLS, WASM } from './setup/setup.mjs';
import { CHECKS, LONG_CHECKS } from './test/checks.mjs';
import { suites } from './test/suites.mjs';

/** Lines that do not help to diagnose a failure: compilation progress and passed tests. */
const NOISE = /^\s*(Compiling|Checking|Downloaded|Running|Finished) |^test .+ \.\.\. ok$|^running \d+ tests?$|^\s*✓/;
/** Enough to diagnose a failure without the full compiler output. */
const SHOWN_LINES = 150;

await conclude(async () => {
  const { values, positionals } = readArguments(
    {
      long: { type: 'boolean', default: false },
      engines: { type: 'boolean', default: false },
      update: { type: 'boolean', default: false },
    },
    'npm test -- [--update] [NAME...]',
  );
  const choice = { long: values.long, engines: values.engines, update: values.update };
  const runners = chooseRunners(choice, positionals);
  await setUp(TOOLCHAIN);
  const missing = values.engines ? await setUpEngines() : [];
  const results = await runInLanes(runners);
  const [passed, failed] = [sumOf(results, 'passed'), sumOf(results, 'failed')];
  for (const sentence of missing) console.log(sentence);
  console.log(`${passed} passed, ${failed} failed`);
  return failed > 0 ? 1 : 0;
});

/** @returns a sentence for each missing engine, with the reason */
async function setUpEngines() {
  await setUp(TOOLS);
  /** @type {string[]} */
  const missing = [];
  for (const engine of ENGINES) {
    try {
      await setUp([engine]);
    } catch (error) {
      if (!(error instanceof UserError)) throw error;
      missing.push(`${error.message} ${process.env.CI === 'true' ? 'Its tests fail.' : 'Its tests are skipped.'}`);
    }
  }
  return missing;
}

/**
 * Fetching packages leaves the processor to the compiler.
 * @param {import('./test/checks.mjs').Runner[]} others
 */
async function setUpOthers(others) {
  if (others.length === 0) return;
  await Promise.all([setUp(TOOLS), setUp(WASM)]);
  // The unit tests and the browser tests would build it at the same time. They also report its failure.
  const isShared = others.some(({ lane }) => lane === 'unit') && others.some(({ name }) => name === 'browser');
  if (isShared && !npmPackage.isFresh()) {
    await withProgress(npmPackage.title, npmPackage.bring).catch(() => undefined);
  }
}

/** @param {import('./test/checks.mjs').Runner[]} runners */
async function runInLanes(runners) {
  const stop = new AbortController();
  const run = (/** @type {string | undefined} */ name) =>
    runInOrder(
      runners.filter(({ lane }) => lane === name),
      stop.signal,
    );
  const compiled = run('cargo');
  const ready = setUpOthers(runners.filter(({ lane }) => lane !== 'cargo'));
  const lanes = [compiled, ready.then(() => run(undefined)), Promise.all([ready, compiled]).then(() => run('unit'))];
  try {
    return (await Promise.all(lanes)).flat();
  } catch (error) {
    // The other suites cannot run without packages or WASM. Stopping all lanes first makes the error the last output.
    stop.abort();
    stopPrograms();
    await Promise.allSettled(lanes);
    throw error;
  }
}

/** @param {import('./test/checks.mjs').Runner[]} runners @param {AbortSignal} signal */
async function runInOrder(runners, signal) {
  const results = [];
  for (const runner of runners) {
    const result = await withProgress(runner.title, runner.run, summary);
    if (signal.aborted) break;
    for (const note of result.notes ?? []) console.log(note);
    if (result.failed > 0) show(runner.title, result);
    results.push(result);
  }
  return results;
}

/** @param {import('./test/checks.mjs').Result[]} results @param {'passed' | 'failed'} what */
function sumOf(results, what) {
  return results.reduce((sum, result) => sum + result[what], 0);
}

/** @param {import('./test/suites.mjs').Choice} choice @param {string[]} names */
function chooseRunners(choice, names) {
  const checks = choice.long ? LONG_CHECKS : CHECKS;
  const all = [...(choice.engines ? [] : checks), ...suites(choice)];
  const unknown = names.find((name) => !all.some((runner) => runner.name === name));
  if (unknown) {
    throw new UserError(`There is no suite named ${unknown}: choose from ${all.map(({ name }) => name).join(', ')}.`);
  }
  return names.length > 0 ? all.filter((runner) => names.includes(runner.name)) : all;
}

/** @param {import('./test/checks.mjs').Result} result */
function summary({ passed, failed, skipped }) {
  return [`${passed} passed`, `${failed} failed`, ...(skipped > 0 ? [`${skipped} skipped`] : [])].join(', ');
}

/** @param {string} title @param {import('./test/checks.mjs').Result} result */
function show(title, { output, trouble }) {
  const lines = output.split('\n').filter((line) => !NOISE.test(line));
  console.log(`---- ${title}`);
  if (lines.length > SHOWN_LINES) console.log(`(the last ${SHOWN_LINES} of ${lines.length} lines)`);
  console.log(lines.slice(-SHOWN_LINES).join('\n'));
  if (trouble) console.log(`${title} failed: ${trouble}.`);
  console.log('----');
}
