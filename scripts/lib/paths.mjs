/** Where things lie in the repository, found from this file, so that no command depends on the working directory. */

import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** The repository's top folder, absolute. */
export const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));

/** An absolute path from one relative to the top folder, with `/` between its parts. */
export function inRoot(/** @type {string} */ path) {
  return join(root, ...path.split('/'));
}
