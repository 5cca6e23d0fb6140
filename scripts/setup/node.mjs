/** Checks the Node version before anything else runs. */

import { readFileSync } from 'node:fs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';

/** Throws if Node is older than the version in package.json. */
export function requireNode() {
  const wanted = JSON.parse(readFileSync(inRoot('package.json'), 'utf8')).engines.node.replace('>=', '');
  const found = process.versions.node;
  if (isAtLeast(found, wanted)) return;
  throw new UserError(
    `Node ${found} is too old: install Node ${wanted} or newer from https://nodejs.org, then try again.`,
  );
}

function isAtLeast(/** @type {string} */ found, /** @type {string} */ wanted) {
  const [a, b] = [found, wanted].map((version) => version.split('.').map(Number));
  for (let i = 0; i < 3; i++) {
    if (a[i] !== b[i]) return a[i] > b[i];
  }
  return true;
}
