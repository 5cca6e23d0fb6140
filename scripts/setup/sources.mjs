/** Source files, and digests that detect changes of them. */

import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../lib/paths.mjs';

/**
 * The SHA-256 of path, NUL, content, NUL of each file, sorted by path. sim-wasm/xtask/src/stamp.rs computes the same.
 *
 * @param {readonly string[]} paths of files and folders; a missing one counts as empty
 * @param {string} [folder] that the paths are relative to. Default: the repository
 */
export function digestOf(paths, folder = root) {
  const hash = createHash('sha256');
  for (const path of paths.flatMap((each) => filesUnder(each, folder)).sort()) {
    hash
      .update(`${path}\0`)
      .update(readFileSync(join(folder, path)))
      .update('\0');
  }
  return hash.digest('hex');
}

/**
 * The path itself if it is a file, and none if it does not exist.
 *
 * @param {string} path with `/` as separator
 * @param {string} [folder] that the path is relative to. Default: the repository
 * @returns {string[]} relative to the same folder
 */
export function filesUnder(path, folder = root) {
  const found = statSync(join(folder, path), { throwIfNoEntry: false });
  if (!found?.isDirectory()) return found ? [path] : [];
  return readdirSync(join(folder, path)).flatMap((name) => filesUnder(`${path}/${name}`, folder));
}
