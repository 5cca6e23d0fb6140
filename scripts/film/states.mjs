/** Saved states of a take, shared by the shards of a shot: whoever comes first to a step writes it. */

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { UserError } from '../lib/userError.mjs';
import { prepareFolder, writeWhole } from './files.mjs';

const NAME = /^state-(\d+)\.bin$/;

/**
 * @typedef {object} StateHeader the first line of a file, as JSON
 * @property {string} link in its canonical form
 * @property {string} version
 * @property {number} step
 * @property {string} hash of the state
 */

export class StateFolder {
  #folder;
  /** @type {{ link: string, version: string }} */
  #shot = { link: '', version: '' };

  /** @param {string} folder */
  constructor(folder) {
    this.#folder = folder;
  }

  prepare() {
    prepareFolder(this.#folder);
  }

  /**
   * Compares the states in the folder with a shot.
   *
   * @param {{ link: string, version: string }} shot
   * @throws {UserError} when one is of another link or version
   */
  enter({ link, version }) {
    this.#shot = { link, version };
    for (const step of this.#steps()) this.#read(step);
  }

  /** The latest state at or before a step. */
  latest(/** @type {number} */ step) {
    const found = this.#steps().findLast((each) => each <= step);
    return found === undefined ? undefined : this.#read(found);
  }

  /**
   * @param {number} step
   * @param {string} hash
   * @param {Uint8Array} state
   */
  async save(step, hash, state) {
    const path = this.#path(step);
    if (existsSync(path)) return;
    /** @type {StateHeader} */
    const header = { ...this.#shot, step, hash };
    await writeWhole(path, Buffer.concat([Buffer.from(`${JSON.stringify(header)}\n`), state]));
  }

  #steps() {
    return readdirSync(this.#folder)
      .flatMap((name) => NAME.exec(name)?.slice(1).map(Number) ?? [])
      .sort((a, b) => a - b);
  }

  #read(/** @type {number} */ step) {
    const path = this.#path(step);
    const content = readFileSync(path);
    const end = content.indexOf('\n');
    /** @type {StateHeader} */
    let header;
    try {
      header = JSON.parse(content.toString('utf8', 0, end));
    } catch {
      throw new UserError(`${path} is damaged: delete it.`);
    }
    for (const key of /** @type {const} */ (['link', 'version'])) {
      if (header[key] === this.#shot[key]) continue;
      throw new UserError(
        `${path} is of the ${key} ${header[key]}, not of ${this.#shot[key]}: choose another folder for the states.`,
      );
    }
    return { hash: header.hash, bytes: content.subarray(end + 1) };
  }

  #path(/** @type {number} */ step) {
    return join(this.#folder, `state-${String(step).padStart(6, '0')}.bin`);
  }
}
