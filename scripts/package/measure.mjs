/** What a page fetches of the package, and what the script for CDNs is to be named with. */

import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';

/** Bytes of a file as it comes over the wire, in kilobytes. @param {string} path */
export function kilobytes(path) {
  return gzipSync(readFileSync(path), { level: 9 }).length / 1000;
}

/** For `<script integrity>`. @param {string} path */
export function integrity(path) {
  return `sha384-${createHash('sha384').update(readFileSync(path)).digest('base64')}`;
}

/** What a CDN is asked for: the script first. @param {string} folder that it lies in */
export function hashes(folder) {
  const files = ['cartoon-smoke.min.js', 'wasm/core/bindings_bg.wasm', 'wasm/physics/bindings_bg.wasm'];
  return files.map((file) => ({ file, integrity: integrity(join(folder, file)), kB: kilobytes(join(folder, file)) }));
}
