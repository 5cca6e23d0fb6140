/** Transfer sizes of the package, and the integrity hash of the script for CDNs. */

import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';

/**
 * Size of a file over the network with gzip, in kilobytes.
 * @param {string} path
 */
export function kilobytes(path) {
  return gzipSync(readFileSync(path), { level: 9 }).length / 1000;
}

/**
 * For `<script integrity>`.
 * @param {string} path
 */
export function integrity(path) {
  return `sha384-${createHash('sha384').update(readFileSync(path)).digest('base64')}`;
}

/**
 * The files that are loaded from a CDN, the script first.
 * @param {string} folder that contains them
 */
export function hashes(folder) {
  const wasm = ['core', 'meshes', 'physics'].map((variant) => `wasm/${variant}/bindings_bg.wasm`);
  const files = ['cartoon-smoke.min.js', ...wasm];
  return files.map((file) => ({ file, integrity: integrity(join(folder, file)), kB: kilobytes(join(folder, file)) }));
}
