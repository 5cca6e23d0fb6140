/** Paths in the repository, relative to this file, so that commands do not depend on the working directory. */

import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** Absolute path of the repository root. */
export const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));

/** The absolute path for a path relative to the repository root, with `/` as separator. */
export function inRoot(/** @type {string} */ path) {
  return join(root, ...path.split('/'));
}
