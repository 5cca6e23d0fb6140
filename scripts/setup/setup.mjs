/** Installs or builds missing components. */

import { withProgress } from '../lib/progress.mjs';
import { UserError } from '../lib/userError.mjs';
import * as browser from './browser.mjs';
import { requireNode } from './node.mjs';
import * as packages from './packages.mjs';
import * as toolchain from './toolchain.mjs';
import * as wasm from './wasm.mjs';

/**
 * @typedef {object} Component a prerequisite of a command
 * @property {string} title
 * @property {() => boolean | Promise<boolean>} isFresh whether it is present and up to date; quick, without side
 * effects
 * @property {(say: (line: string) => void) => Promise<void>} bring installs or builds it, or throws a UserError
 */

/**
 * Components of the page, in setup order.
 * @type {Component[]}
 */
export const PAGE = [packages, toolchain, wasm];
/**
 * Components of the tests and the benchmarks.
 * @type {Component[]}
 */
export const TESTS = [...PAGE, browser];
/**
 * TESTS in three parts: cargo's tests need the toolchain alone, and WASM is built while packages are fetched.
 * @type {Component[]}
 */
export const TOOLCHAIN = [toolchain];
/** @type {Component[]} */
export const WASM = [wasm];
/** @type {Component[]} */
export const TOOLS = [packages, browser];
/** Components for pictures that do not use the simulator. */
export const PICTURES = [packages, browser];

/**
 * Sets up each stale component and reports it.
 *
 * @param {Component[]} components
 * @throws {UserError} when a component is unavailable
 */
export async function setUp(components) {
  requireNode();
  const fresh = [];
  for (const component of components) {
    if (await component.isFresh()) {
      fresh.push(component.title);
      continue;
    }
    await withProgress(component.title, component.bring);
    if (!(await component.isFresh())) {
      throw new UserError(
        `${component.title}: installed, but still not up to date; if files are being edited, try again.`,
      );
    }
  }
  if (fresh.length > 0) console.log(`Already up to date: ${fresh.join(', ')}.`);
}
