/** The simulator as WASM, built from sim-wasm into src/simulator/wasm. Rebuilt only when its sources change. */

import { existsSync, readFileSync } from 'node:fs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';
import { digestOf } from './sources.mjs';
import { cargo } from './toolchain.mjs';

export const title = 'WASM build';

// Inputs and outputs of the build. Keep in sync with sim-wasm/xtask/src/stamp.rs and build.rs.
const SOURCES = [
  '../scripts/patches/rapier.rs',
  '.cargo/config.toml',
  'Cargo.lock',
  'Cargo.toml',
  'rust-toolchain.toml',
  ...['bindings', 'sim', 'world', 'xtask'].flatMap((crate) => [`${crate}/Cargo.toml`, `${crate}/src`]),
];
const VARIANTS = ['core', 'meshes', 'physics'];
const FILES = ['bindings.js', 'bindings.d.ts', 'bindings_bg.wasm'];

/** Whether all variants were built from the current sources. Compiles nothing. */
export function isFresh() {
  const built = VARIANTS.flatMap((variant) => FILES.map((file) => `src/simulator/wasm/${variant}/${file}`));
  const stamp = inRoot('src/simulator/wasm/stamp.txt');
  if (![stamp, ...built.map(inRoot)].every((path) => existsSync(path))) return false;
  return readFileSync(stamp, 'utf8').trim() === digestOf(SOURCES, inRoot('sim-wasm'));
}

/** @param {(line: string) => void} say */
export async function bring(say) {
  // Not the alias `cargo xtask wasm`: it compiles xtask silently, which takes longest on the first run.
  const outcome = await cargo(['run', '--locked', '--package', 'xtask', '--profile', 'xtask', '--', 'wasm'], say);
  if (outcome.status !== 0) throw explain(outcome);
}

/** @returns {UserError} */
function explain(/** @type {import('../lib/command.mjs').Outcome} */ { output }) {
  const linker = /linker [`']?([\w.-]+)[`']? not found/.exec(output)?.[1];
  if (linker) {
    return new UserError(
      `Rust found no linker (${linker}): install a C compiler, on Debian with apt-get install build-essential, then try again.`,
    );
  }
  if (
    /failed to (download|fetch|get successful HTTP)|failed to query replaced source|Could not resolve host|spurious network/i.test(
      output,
    )
  ) {
    const cause = /(?:Caused by:\s+)(?![\s\S]*Caused by:)(.+)/.exec(output)?.[1] ?? 'no reason given';
    return new UserError(
      `cargo could not download the Rust crates (${cause.trim()}): check the network, then try again.`,
    );
  }
  return new UserError('The WASM build failed: see the compiler output above.', output);
}
