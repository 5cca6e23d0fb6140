/** Counts passed and failed tests in the machine-readable reports of the runners. */

import { existsSync, readFileSync } from 'node:fs';

/**
 * @typedef {object} Tally
 * @property {number} passed
 * @property {number} failed
 * @property {number} skipped
 */

/**
 * The counts of a vitest JSON report. A file that fails before its first test counts as one failure.
 *
 * @param {any} report
 * @returns {Tally}
 */
export function tallyVitest(report) {
  const stillborn = report.testResults.filter(
    (/** @type {any} */ file) =>
      file.status === 'failed' && !file.assertionResults.some((/** @type {any} */ test) => test.status === 'failed'),
  );
  return {
    passed: report.numPassedTests,
    failed: report.numFailedTests + stillborn.length,
    skipped: report.numPendingTests + report.numTodoTests,
  };
}

/**
 * The notes in `task.meta.note` of a vitest JSON report, sorted by text.
 *
 * @param {any} report
 * @returns {string[]}
 */
export function notesIn(report) {
  const tests = report.testResults.flatMap((/** @type {any} */ file) => file.assertionResults);
  return tests.flatMap((/** @type {any} */ { meta }) => meta?.note ?? []).sort();
}

/**
 * The counts of a Playwright JSON report. A test that passed only on retry counts as failed, as does an error outside
 * of a test, such as a file that cannot be loaded.
 *
 * @param {any} report
 * @returns {Tally}
 */
export function tallyPlaywright(report) {
  const { expected, unexpected, flaky, skipped } = report.stats;
  return { passed: expected, failed: unexpected + flaky + report.errors.length, skipped };
}

/**
 * The sum of all `test result:` lines that cargo printed, one per test program.
 *
 * @param {string} output
 * @returns {Tally}
 */
export function tallyCargo(output) {
  const tally = { passed: 0, failed: 0, skipped: 0 };
  for (const line of output.matchAll(/^test result: \w+\. (\d+) passed; (\d+) failed; (\d+) ignored/gm)) {
    tally.passed += Number(line[1]);
    tally.failed += Number(line[2]);
    tally.skipped += Number(line[3]);
  }
  return tally;
}

/**
 * Adds a failure for a runner that exited with an error without reporting one, or that ran no tests.
 *
 * @param {Tally | undefined} tally undefined when the runner wrote no report
 * @param {number} status its exit status
 * @returns {Tally & { trouble?: string }}
 */
export function settle(tally, status) {
  if (!tally) return { passed: 0, failed: 1, skipped: 0, trouble: `it left no report (status ${status})` };
  if (tally.failed > 0) return tally;
  if (status !== 0) return { ...tally, failed: 1, trouble: `it ended with status ${status} although no test failed` };
  if (tally.passed === 0) return { ...tally, failed: 1, trouble: 'it ran no test' };
  return tally;
}

/**
 * Sums the results of commands whose standard output ends with `N passed, N failed`. A command without such a line, or
 * one that exits with an error without reporting a failure, counts as one failure.
 *
 * @param {readonly { status: number, output: string }[]} outcomes
 * @returns {{ passed: number, failed: number }}
 */
export function sumEndings(outcomes) {
  const sum = { passed: 0, failed: 0 };
  for (const { status, output } of outcomes) {
    const ending = [...output.matchAll(/^(\d+) passed, (\d+) failed\r?$/gm)].at(-1);
    const [passed, failed] = ending ? [Number(ending[1]), Number(ending[2])] : [0, 1];
    sum.passed += passed;
    sum.failed += failed === 0 && status !== 0 ? 1 : failed;
  }
  return sum;
}

/**
 * The reports of failures that `npm test` prints between a line `---- TITLE` and a line `----`, with both lines.
 *
 * @param {string} output
 * @returns {string[]}
 */
export function failureReports(output) {
  return output.match(/^---- .+\n[^]*?^----$/gm) ?? [];
}

/** The parsed JSON file, or undefined if it is missing or invalid, for example after a crash. */
export function readReport(/** @type {string} */ path) {
  try {
    return existsSync(path) ? JSON.parse(readFileSync(path, 'utf8')) : undefined;
  } catch {
    return undefined;
  }
}
