/** The commands: their arguments, their ports, the dispatch of the benchmark. */
import { spawnSync } from 'node:child_process';
import { cpSync } from 'node:fs';
import { createServer } from 'node:net';
import { fileURLToPath } from 'node:url';
import { afterEach, beforeEach, describe, expect, test } from 'vitest';
import { Project } from '../../support/project.ts';

let project: Project;
beforeEach(() => {
  project = new Project();
});
afterEach(() => project.dispose());

describe('ports', () => {
  test.each(['0', '65536', '80.5', '-1', 'abc', ''])('%j is rejected by name', (port) => {
    const ending = project.run('start.mjs', [`--port=${port}`]);
    expect(ending).toMatchObject({
      status: 1,
      errors: [`--port ${port} is not a port: give a whole number from 1 to 65535.`],
    });
  });

  test.each(['127.0.0.1', '::1', '0.0.0.0'])(
    'one that is in use at %s is rejected before anything is installed',
    async (host) => {
      const server = createServer();
      await new Promise<void>((resolve) => server.listen(0, host, resolve));
      const { port } = server.address() as { port: number };
      for (const [script, command] of [
        ['start.mjs', 'npm start --'],
        ['preview.mjs', 'npm run preview --'],
      ]) {
        const ending = project.run(script, ['--port', String(port)]);
        expect(ending.errors).toEqual([
          `Port ${port} is in use: stop the program that uses it, or choose another with ${command} --port ${port + 1}.`,
        ]);
        expect(ending).toMatchObject({ status: 1, output: '' });
      }
      await new Promise((resolve) => server.close(resolve));
    },
  );

  test('an unknown option prints the usage', () => {
    expect(project.run('start.mjs', ['--prot', '1']).errors).toEqual([
      `Unknown option '--prot'. Usage: npm start -- [--port N]`,
    ]);
  });
});

describe('.ci/run', () => {
  const said = (first: string, second: string) => {
    project.program('npm', `echo "npm $@ with CI=$CI"\nif [ "$1" = test ]; then ${first}; else ${second}; fi`);
    cpSync(fileURLToPath(new URL('../../../.ci', import.meta.url)), project.path('.ci'), { recursive: true });
    const { status, stdout } = spawnSync('/bin/bash', [project.path('.ci/run')], {
      encoding: 'utf8',
      env: { PATH: project.path('programs') },
    });
    return { status, output: stdout };
  };

  test('runs both commands, also if the first fails, and exits with the combined status', () => {
    const { status, output } = said('echo "5 passed, 2 failed"; exit 1', 'echo "30 passed, 0 failed"');
    expect(status).toBe(1);
    expect(output.trimEnd().split('\n')).toEqual([
      'npm test with CI=true',
      '5 passed, 2 failed',
      'npm run test:engines with CI=true',
      '30 passed, 0 failed',
      '35 passed, 2 failed',
    ]);
  });

  test('succeeds only if both do', () => {
    const fine = 'echo "5 passed, 0 failed"';
    expect(said(fine, fine)).toMatchObject({ status: 0, output: expect.stringMatching(/\n10 passed, 0 failed\n$/) });
    expect(said(fine, 'true')).toMatchObject({ status: 1, output: expect.stringMatching(/\n5 passed, 1 failed\n$/) });
  });
});

describe('bench', () => {
  beforeEach(() => {
    // This test does not cover the suites' dependencies.
    project.write('scripts/setup/setup.mjs', 'export const TESTS = []; export async function setUp() {}');
    project.write(
      'tests/bench/smoke.mjs',
      `export async function run({ quick }) {
        return [{ name: 'smoke.speed', value: quick ? 4 : 1 / 3, unit: 'x', range: [0.25, 5], rounds: 7, note: 'of puffs' }];
      }`,
    );
  });

  test('lists the suites when none or an unknown one is named', () => {
    project.write('tests/bench/fire.mjs', '');
    expect(project.run('bench.mjs').errors).toEqual([
      'Name one suite: npm run bench -- SUITE [--quick] [--json FILE]. The suites are fire, smoke.',
    ]);
    const ending = project.run('bench.mjs', ['ice']);
    expect(ending).toMatchObject({ status: 1, errors: ['There is no suite named ice. The suites are fire, smoke.'] });
  });

  test('prints a table and writes the figures', () => {
    const ending = project.run('bench.mjs', ['smoke', '--quick', '--json', 'out/figures.json']);
    expect(ending.status).toBe(0);
    expect(ending.output).toMatch(/^smoke\.speed +4 x +0\.25 to 5 +7 +of puffs$/m);
    expect(JSON.parse(project.read('out/figures.json'))).toEqual({
      suite: 'smoke',
      commit: 'unknown',
      figures: [{ name: 'smoke.speed', value: 4, unit: 'x', range: [0.25, 5], rounds: 7, note: 'of puffs' }],
    });
    expect(project.run('bench.mjs', ['smoke']).output).toMatch(/^smoke\.speed +0\.3333 x/m);
  });

  test('a suite that measures nothing or throws fails', () => {
    project.write('tests/bench/smoke.mjs', 'export const run = async () => [];');
    expect(project.run('bench.mjs', ['smoke'])).toMatchObject({
      status: 1,
      errors: ['The suite smoke measured nothing.'],
    });
    project.write('tests/bench/smoke.mjs', 'export const run = async () => { throw new Error("no page"); };');
    expect(project.run('bench.mjs', ['smoke'])).toMatchObject({ status: 1, errors: ['no page'] });
  });
});

describe('test', () => {
  function withSuites(code: string): void {
    withSetUp('');
    project.write('scripts/test/checks.mjs', 'export const CHECKS = []; export const LONG_CHECKS = [];');
    const run = `import { run } from '../lib/command.mjs';`;
    project.write('scripts/test/suites.mjs', `${run} export const suites = () => [${code}];`);
  }
  function withSetUp(body: string): void {
    const code = `export const TOOLCHAIN = ['toolchain'], TOOLS = ['tools'], WASM = ['wasm']; export async function setUp(components) { ${body} }`;
    project.write('scripts/setup/setup.mjs', code);
  }
  const suite = (name: string, result: object) =>
    `{ name: '${name}', title: '${name}', run: async () => (${JSON.stringify({ skipped: 0, output: `said by ${name}`, ...result })}) }`;

  test('runs all suites even if one fails, and prints the totals', () => {
    withSuites([suite('a', { passed: 2, failed: 1 }), suite('b', { passed: 3, failed: 0 })].join());
    const { status, output } = project.run('test.mjs');
    expect(status).toBe(1);
    expect(output).toMatch(/said by a/);
    expect(output).not.toMatch(/said by b/);
    expect(output.trimEnd().split('\n').at(-1)).toBe('5 passed, 1 failed');
  });

  test('runs cargo in parallel with the rest', () => {
    const passes = '{ passed: 1, failed: 0, skipped: 0, output: "" }';
    withSuites(`
      { name: 'a', title: 'a', lane: 'cargo', run: () => new Promise((end) => { globalThis.endA = () => end(${passes}); }) },
      { name: 'b', title: 'b', run: async () => { globalThis.endA(); return ${passes}; } },
    `);
    const { status, output } = project.run('test.mjs');
    expect(status).toBe(0);
    expect(output.trimEnd().split('\n').at(-1)).toBe('2 passed, 0 failed');
  });

  test('without WASM cargo is stopped, nothing else starts, and only the reason is printed', () => {
    project.write('endless.mjs', `console.log('I run'); setInterval(() => {}, 1e6);`);
    withSuites(`
      { name: 'a', title: 'a', lane: 'cargo', run: () => new Promise((end) => {
        globalThis.hasBegun = new Promise((begun) => run(process.execPath, ['endless.mjs'], { onLine: begun }).then(end));
      }) },
      { name: 'b', title: 'b', lane: 'cargo', run: () => console.log('b began') },
      { name: 'c', title: 'c', run: () => console.log('c began') },
    `);
    withSetUp(`if (components.includes('wasm')) { await globalThis.hasBegun; throw new Error('no WASM'); }`);
    const { status, output, errors } = project.run('test.mjs');
    expect([status, errors]).toEqual([1, ['no WASM']]);
    expect(output).not.toMatch(/began|\d passed/);
  });

  test('succeeds only if nothing failed', () => {
    withSuites(suite('b', { passed: 3, failed: 0 }));
    expect(project.run('test.mjs')).toMatchObject({ status: 0, errors: [] });
  });

  test('runs the named suites, and lists all of them for an unknown name', () => {
    withSuites([suite('a', { passed: 0, failed: 1 }), suite('b', { passed: 3, failed: 0 })].join());
    expect(project.run('test.mjs', ['b']).status).toBe(0);
    expect(project.run('test.mjs', ['c']).errors).toEqual(['There is no suite named c: choose from a, b.']);
  });
});

test('the long browser tests can be loaded, as npm run test:long would', () => {
  const { stdout } = spawnSync(process.execPath, ['node_modules/@playwright/test/cli.js', 'test', '--list'], {
    encoding: 'utf8',
    env: { ...process.env, TEST_LONG: '1' },
  });
  expect(Number(/Total: (\d+) tests/.exec(stdout)?.[1]), stdout).toBeGreaterThan(100);
});
