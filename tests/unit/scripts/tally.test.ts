/** The test counter: a runner's failure never counts as success. */
import { expect, test } from 'vitest';

interface Tally {
  passed: number;
  failed: number;
  skipped: number;
  trouble?: string;
}

interface TallyScript {
  tallyVitest(report: unknown): Tally;
  tallyPlaywright(report: unknown): Tally;
  tallyCargo(output: string): Tally;
  settle(tally: Tally | undefined, status: number): Tally;
  notesIn(report: unknown): string[];
  failureReports(output: string): string[];
  sumEndings(outcomes: { status: number; output: string }[]): { passed: number; failed: number };
}

// Not a literal path, because plain JavaScript has no types here.
const path = '../../../scripts/test/tally.mjs';
const { tallyVitest, tallyPlaywright, tallyCargo, settle, notesIn, failureReports, sumEndings } = (await import(
  path
)) as TallyScript;

test('vitest: a file that fails before its first test is a failure', () => {
  const testResults = [
    { status: 'failed', assertionResults: [{ status: 'failed' }, { status: 'passed' }] },
    { status: 'failed', assertionResults: [] },
    { status: 'passed', assertionResults: [{ status: 'passed' }] },
  ];
  const report = { numPassedTests: 2, numFailedTests: 1, numPendingTests: 1, numTodoTests: 1, testResults };
  expect(tallyVitest(report)).toEqual({ passed: 2, failed: 2, skipped: 2 });
});

test('Playwright: flaky tests and errors outside of tests are failures', () => {
  const report = { stats: { expected: 5, unexpected: 1, flaky: 2, skipped: 3 }, errors: [{}] };
  expect(tallyPlaywright(report)).toEqual({ passed: 5, failed: 4, skipped: 3 });
});

test('cargo: the test programs are added up', () => {
  const output = [
    'test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.00s',
    'test result: FAILED. 3 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.00s',
  ].join('\n');
  expect(tallyCargo(output)).toEqual({ passed: 15, failed: 2, skipped: 1 });
});

test('a runner that crashes, exits with an error or runs nothing fails', () => {
  const none = { passed: 0, failed: 0, skipped: 0 };
  expect(settle(undefined, 0)).toMatchObject({ failed: 1, trouble: 'it left no report (status 0)' });
  expect(settle({ ...none, passed: 4 }, 1)).toMatchObject({ passed: 4, failed: 1 });
  expect(settle({ ...none, skipped: 4 }, 0)).toMatchObject({ failed: 1, trouble: 'it ran no test' });
  expect(settle({ ...none, failed: 2 }, 1)).toMatchObject({ failed: 2 });
  expect(settle({ ...none, passed: 1 }, 0)).toEqual({ ...none, passed: 1 });
});

test('vitest: notes of tests are printed in order', () => {
  const noting = (...notes: (string | undefined)[]) => ({
    assertionResults: notes.map((note) => ({ meta: { note } })),
  });
  expect(notesIn({ testResults: [noting('b', undefined), noting(), noting('a')] })).toEqual(['a', 'b']);
});

test('reports of failures are found among other output', () => {
  const reports = ['---- Lint\n1 error\n---- not a title\n----', '---- Rust tests\nfailed\n----'];
  expect(failureReports(`Lint: 0 passed\n${reports.join('\nTypes: 1 passed\n')}\n1 passed, 2 failed\n`)).toEqual(
    reports,
  );
  expect(failureReports('12 passed, 0 failed\n')).toEqual([]);
});

test('totals add up, and a command that prints nothing or exits with an error fails', () => {
  const passed = { status: 0, output: 'Site: done\n12 passed, 0 failed\n' };
  expect(sumEndings([passed, { status: 1, output: '3 passed, 2 failed\n\n' }])).toEqual({ passed: 15, failed: 2 });
  expect(sumEndings([passed, { status: 0, output: 'Unit tests: 3 passed, 0 failed (1 s)' }])).toEqual({
    passed: 12,
    failed: 1,
  });
  expect(sumEndings([{ ...passed, status: 1 }, passed])).toEqual({ passed: 24, failed: 1 });
  expect(sumEndings([{ status: 127, output: '' }])).toEqual({ passed: 0, failed: 1 });
});
