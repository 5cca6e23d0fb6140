/** Finds out what is missing and gets it. */

import { withProgress } from '../lib/progress.mjs';
import { UserError } from '../lib/userError.mjs';
import * as browser from './browser.mjs';
import { demandNode } from './node.mjs';
import * as packages from './packages.mjs';
import * as toolchain from './toolchain.mjs';
import * as wasm from './wasm.mjs';

/**
 * @typedef {object} Component something that has to be there before a command can do its work
 * @property {string} title
 * @property {() => boolean | Promise<boolean>} isFresh whether it is there and up to date; quick, and changes nothing
 * @property {(say: (line: string) => void) => Promise<void>} bring gets it, or throws a UserError
 */

/** What the page needs, in the order of getting it. @type {Component[]} */
export const PAGE = [packages, toolchain, wasm];
/** What the tests and the benchmarks need. @type {Component[]} */
export const TESTS = [...PAGE, browser];
/** The same in two parts, because what cargo tests needs no WASM. @type {Component[]} */
export const TOOLS = TESTS.filter((component) => component !== wasm);
/** @type {Component[]} */
export const WASM = [wasm];
/** For pictures that need no simulator. */
export const PICTURES = [packages, browser];

/**
 * Brings each component that is not fresh and says so.
 *
 * @param {Component[]} components
 * @throws {UserError} when one cannot be had
 */
export async function setUp(components) {
  demandNode();
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
