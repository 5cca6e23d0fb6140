/** The Rust toolchain of sim-wasm/rust-toolchain.toml. rustup's cargo and rustc select it, and install what it lacks. */

import { homedir } from 'node:os';
import { delimiter, join } from 'node:path';
import { run } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';

export const title = 'Rust toolchain';

const PARTS = ['cargo', 'clippy', 'rustfmt', 'rust-std-wasm32-unknown-unknown'];

/**
 * Runs cargo in sim-wasm.
 *
 * @param {string[]} parameters
 * @param {(line: string) => void} [onLine]
 * @param {NodeJS.ProcessEnv} [environment] added to the environment of this process
 */
export function cargo(parameters, onLine, environment) {
  return runRust('cargo', parameters, onLine, environment);
}

/**
 * Runs a cargo command on the native crates, all but xtask. Clippy compiles the crates of the workspace, so that one
 * build serves the lint, the tests and the programs: another selection, or `cargo clippy`, would compile Rapier again.
 *
 * @param {string} command such as `test`
 * @param {string[]} parameters
 * @param {(line: string) => void} [onLine]
 * @param {NodeJS.ProcessEnv} [environment] added to the environment of this process
 */
export function cargoNative(command, parameters, onLine, environment) {
  return cargo([command, '--locked', '--workspace', '--exclude', 'xtask', '--all-features', ...parameters], onLine, {
    RUSTC_WORKSPACE_WRAPPER: 'clippy-driver',
    ...environment,
  });
}

/**
 * Runs rustc in sim-wasm.
 *
 * @param {string[]} parameters
 * @param {(line: string) => void} [onLine]
 */
export function rustc(parameters, onLine) {
  return runRust('rustc', parameters, onLine);
}

/** Whether the toolchain is installed with its target and components. */
export async function isFresh() {
  const { status, output } = await runRust('rustup', ['component', 'list', '--installed']);
  if (status === 127) {
    throw new UserError('rustup was not found: install it from https://rustup.rs, then try again.');
  }
  return status === 0 && PARTS.every((part) => output.split('\n').some((line) => line.startsWith(part)));
}

/** @param {(line: string) => void} say */
export async function bring(say) {
  // Before several programs run cargo, because each would install the toolchain.
  const { status, output } = await cargo(['--version'], say, { RUSTUP_AUTO_INSTALL: '1' });
  if (status === 0) return;
  const reason = /^error: (.+)$/m.exec(output)?.[1] ?? 'no reason given';
  throw new UserError(
    `rustup could not install the toolchain of sim-wasm/rust-toolchain.toml (${reason}): check the network, then try again.`,
  );
}

/**
 * @param {string} program
 * @param {string[]} parameters
 * @param {(line: string) => void} [onLine]
 * @param {NodeJS.ProcessEnv} [added]
 */
function runRust(program, parameters, onLine, added) {
  // Before another cargo, and for a shell that was opened before rustup was installed.
  const home = process.env.CARGO_HOME || join(homedir(), '.cargo');
  const PATH = [join(home, 'bin'), process.env.PATH].filter(Boolean).join(delimiter);
  const environment = { PATH, RUSTUP_AUTO_INSTALL: '0', CARGO_TERM_COLOR: 'never', ...added };
  return run(program, parameters, { folder: inRoot('sim-wasm'), environment, onLine });
}
