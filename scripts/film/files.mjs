/** Files that are either whole or not there, and one sentence for each error of the disk. */

import { createWriteStream, existsSync, mkdirSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { createHash, randomBytes } from 'node:crypto';
import { once } from 'node:events';
import { basename, dirname, join } from 'node:path';
import { pipeline } from 'node:stream/promises';
import { UserError } from '../lib/userError.mjs';

/** Ending of files that are not whole yet. */
const PART = '.part';

/** @type {Set<string>} */
const open = new Set();

/**
 * Writes a file under a temporary name and renames it.
 *
 * @param {string} path
 * @param {string | Uint8Array | AsyncIterable<Uint8Array>} content
 * @returns {Promise<string>} its SHA-256
 * @throws {UserError} when the disk is full or the folder cannot be written
 */
export async function writeWhole(path, content) {
  const part = join(dirname(path), `.${basename(path)}.${randomBytes(4).toString('hex')}${PART}`);
  const hash = createHash('sha256');
  open.add(part);
  try {
    if (typeof content === 'string' || content instanceof Uint8Array) {
      hash.update(content);
      writeFileSync(part, content);
    } else {
      await pipeInto(createWriteStream(part), content, hash);
    }
    renameSync(part, path);
    return hash.digest('hex');
  } catch (error) {
    throw diskError(path, error);
  } finally {
    // If the folder is a file, rmSync throws an error of its own, which would replace the first one.
    if (existsSync(part)) rmSync(part);
    open.delete(part);
  }
}

/** Removes what this process has begun to write. */
export function removeParts() {
  for (const part of open) rmSync(part, { force: true });
}

/**
 * Creates a folder, and proves that files can be written in it.
 *
 * @param {string} folder
 */
export function prepareFolder(folder) {
  const probe = join(folder, `.probe-${randomBytes(4).toString('hex')}`);
  try {
    createFolder(folder);
    writeFileSync(probe, '');
    rmSync(probe);
  } catch (error) {
    throw diskError(folder, error);
  }
}

/** One level at a time: Node's recursive mkdir does not return for a folder in /proc. */
function createFolder(/** @type {string} */ folder) {
  if (existsSync(folder)) return;
  createFolder(dirname(folder));
  try {
    mkdirSync(folder);
  } catch (error) {
    // Another shard may have created it.
    if (!existsSync(folder)) throw error;
  }
}

/**
 * Removes what a killed run left of files with these names.
 *
 * @param {string} folder
 * @param {(name: string) => boolean} isOwn
 */
export function removeLeftovers(folder, isOwn) {
  for (const name of readdirSync(folder)) {
    const [, whole] = /^\.(.+)\.[\da-f]{8}\.part$/.exec(name) ?? [];
    if (whole !== undefined && isOwn(whole)) rmSync(join(folder, name), { force: true });
  }
}

/**
 * @param {import('node:fs').WriteStream} file
 * @param {AsyncIterable<Uint8Array>} content
 * @param {import('node:crypto').Hash} hash
 */
async function pipeInto(file, content, hash) {
  try {
    await pipeline(content, hashing(hash), file);
  } finally {
    // After an error the file may still be about to be created.
    if (!file.closed) await once(file, 'close');
  }
}

/** @param {import('node:crypto').Hash} hash */
function hashing(hash) {
  return async function* (/** @type {AsyncIterable<Uint8Array>} */ chunks) {
    for await (const chunk of chunks) {
      hash.update(chunk);
      yield chunk;
    }
  };
}

/**
 * @param {string} path
 * @param {unknown} error
 */
function diskError(path, error) {
  const { code, message } = /** @type {NodeJS.ErrnoException} */ (error);
  if (code === 'ENOSPC' || code === 'EDQUOT') return new UserError(`The disk is full: ${path} was not written.`);
  if (code === undefined) return error;
  return new UserError(`${path} cannot be written: ${message.split(',')[0]}.`);
}
