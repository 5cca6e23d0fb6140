/** The Rust toolchain of sim-wasm/rust-toolchain.toml, with its target and components. */

import { existsSync, readFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { delimiter, join } from 'node:path';
import { run } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';

export const title = 'Rust toolchain';

/**
 * Executables of components whose name differs.
 * @type {Record<string, string>}
 */
const PROGRAMS = { clippy: 'cargo-clippy' };

/**
 * Runs cargo in sim-wasm with the pinned version, even if another cargo comes first on PATH.
 *
 * @param {string[]} parameters
 * @param {(line: string) => void} [onLine]
 * @param {NodeJS.ProcessEnv} [environment] added to the environment of this process
 */
export function cargo(parameters, onLine, environment) {
  return rustup(['run', readToolchain().channel, 'cargo', ...parameters], onLine, environment);
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
 * Runs rustc in sim-wasm with the pinned version.
 *
 * @param {string[]} parameters
 * @param {(line: string) => void} [onLine]
 */
export function rustc(parameters, onLine) {
  return rustup(['run', readToolchain().channel, 'rustc', ...parameters], onLine);
}

/** Whether the toolchain is installed with all required targets and components. */
export async function isFresh() {
  const { channel, targets, components } = readToolchain();
  const asked = await rustup(['run', channel, 'rustc', '--print', 'sysroot']);
  if (asked.status === 127) {
    throw new UserError('rustup was not found: install it from https://rustup.rs, then try again.');
  }
  if (asked.status !== 0) return false;
  const sysroot = asked.output.split('\n').at(-1) ?? '';
  const suffix = process.platform === 'win32' ? '.exe' : '';
  return (
    targets.every((target) => existsSync(join(sysroot, 'lib', 'rustlib', target, 'lib'))) &&
    components.every((name) => existsSync(join(sysroot, 'bin', (PROGRAMS[name] ?? name) + suffix)))
  );
}

/** @param {(line: string) => void} say */
export async function bring(say) {
  const { channel, targets, components } = readToolchain();
  const outcome = await rustup(
    ['toolchain', 'install', channel, '--profile', 'minimal', '--no-self-update'].concat(
      components.flatMap((name) => ['--component', name]),
      targets.flatMap((name) => ['--target', name]),
    ),
    say,
  );
  if (outcome.status === 0) return;
  const reason = /^error: (.+)$/m.exec(outcome.output)?.[1] ?? 'no reason given';
  throw new UserError(
    `rustup could not install Rust ${channel} with ${targets.join(', ')} (${reason}): check the network, then try again.`,
  );
}

/** Parses the toolchain file, which uses only simple `key = value` lines. */
function readToolchain() {
  const text = readFileSync(inRoot('sim-wasm/rust-toolchain.toml'), 'utf8');
  const value = (/** @type {string} */ key) => new RegExp(`^${key} = (.+)$`, 'm').exec(text)?.[1] ?? '[]';
  return {
    channel: /** @type {string} */ (JSON.parse(value('channel'))),
    targets: /** @type {string[]} */ (JSON.parse(value('targets'))),
    components: /** @type {string[]} */ (JSON.parse(value('components'))),
  };
}

/**
 * @param {string[]} parameters
 * @param {(line: string) => void} [onLine]
 * @param {NodeJS.ProcessEnv} [added]
 */
function rustup(parameters, onLine, added) {
  // A shell opened before rustup was installed does not have its folder on PATH.
  const home = process.env.CARGO_HOME || join(homedir(), '.cargo');
  const PATH = [process.env.PATH, join(home, 'bin')].filter(Boolean).join(delimiter);
  // No implicit installation: `bring` installs what is missing and reports its own error.
  const environment = { PATH, RUSTUP_AUTO_INSTALL: '0', CARGO_TERM_COLOR: 'never', ...added };
  return run('rustup', parameters, { folder: inRoot('sim-wasm'), environment, onLine });
}
