/**
 * `npm run fuzz -- [--minutes N] [--rigids]`: coverage-guided fuzzing (libFuzzer) of the simulator with mutated
 * configurations, saved states and takes. Default: one minute. Findings are kept in .cache/fuzz.
 */

import { mkdirSync } from 'node:fs';
import { cargo } from './setup/toolchain.mjs';
import { readArguments } from './lib/arguments.mjs';
import { run } from './lib/command.mjs';
import { inRoot } from './lib/paths.mjs';
import { conclude, UserError } from './lib/userError.mjs';

const TARGET = 'x86_64-unknown-linux-gnu';
/** Flags that make a stable compiler instrument edges and comparisons for libFuzzer. */
const COVERAGE = [
  '-Cpasses=sancov-module',
  '-Cllvm-args=-sanitizer-coverage-level=4',
  '-Cllvm-args=-sanitizer-coverage-inline-8bit-counters',
  '-Cllvm-args=-sanitizer-coverage-pc-table',
  '-Cllvm-args=-sanitizer-coverage-trace-compares',
  '--cfg=fuzzing',
];

await conclude(async () => {
  const { values } = readArguments(
    { minutes: { type: 'string', default: '1' }, rigids: { type: 'boolean', default: false } },
    'npm run fuzz -- [--minutes N] [--rigids]',
  );
  const minutes = Number(values.minutes);
  if (!(minutes > 0 && minutes <= 1440)) {
    throw new UserError(`--minutes ${values.minutes} is out of range: use a number above 0 and at most 1440.`);
  }
  await compile(values.rigids);
  const [seeds, corpus, findings] = ['seeds', 'corpus', 'findings'].map(folder);
  const program = inRoot(`sim-wasm/target/fuzz/${TARGET}/release/fuzz`);
  await demand(run(program, [], { environment: { FUZZ_SEEDS: seeds } }), 'The first inputs could not be written');
  const limits = [`-max_total_time=${Math.ceil(60 * minutes)}`, '-max_len=8192', '-timeout=10', '-rss_limit_mb=2048'];
  const parameters = [...limits, '-print_final_stats=1', `-artifact_prefix=${findings}/`, corpus, seeds];
  const { status, output } = await run(program, parameters, { onLine: (line) => console.log(line) });
  const executions = /number_of_executed_units:\s*(\d+)/.exec(output)?.[1] ?? 'no';
  if (status !== 0) throw new UserError(`The simulator failed on the input in ${findings}.`);
  console.log(`${executions} inputs in ${minutes} minutes without a fault.`);
});

function compile(/** @type {boolean} */ hasRigids) {
  const parameters = ['build', '--release', '--locked', '--manifest-path', inRoot('sim-wasm/fuzz/Cargo.toml')];
  // With an explicit target, the flags do not apply to build scripts, which do not link libFuzzer.
  parameters.push('--target', TARGET, '--target-dir', inRoot('sim-wasm/target/fuzz'));
  if (hasRigids) parameters.push('--features', 'rigids');
  parameters.push('--config', `build.rustflags=${JSON.stringify(COVERAGE)}`);
  return demand(
    cargo(parameters, (line) => console.log(line)),
    'The fuzz target does not compile',
  );
}

async function demand(
  /** @type {Promise<import('./lib/command.mjs').Outcome>} */ pending,
  /** @type {string} */ sentence,
) {
  const { status, output } = await pending;
  if (status !== 0) throw new UserError(`${sentence}: ${output.split('\n').slice(-5).join(' ')}`);
}

function folder(/** @type {string} */ name) {
  const path = inRoot(`.cache/fuzz/${name}`);
  mkdirSync(path, { recursive: true });
  return path;
}
