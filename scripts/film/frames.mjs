/** The folder of a shot: which frames are finished, and whether all are of one shot, one browser and one renderer. */

import { createHash } from 'node:crypto';
import { createReadStream, existsSync, mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { UserError } from '../lib/userError.mjs';
import { prepareFolder, removeLeftovers, writeWhole } from './files.mjs';

const SIDECAR = /^frame-\d{6}\.json$/;

/**
 * What all frames of a folder have in common.
 * @typedef {Omit<import('../../src/demo/film/order.ts').FilmOrder, 'statesEvery'> & { start: number, version: string, browser: string, renderer: string }} ShotIdentity
 *
 * The content of a sidecar.
 * @typedef {object} Sidecar
 * @property {number} frame
 * @property {number} step
 * @property {string} hash of the simulator's state
 * @property {ShotIdentity} shot
 * @property {Record<string, string>} files SHA-256 by name
 */

/** Names of the properties of a shot, for messages. */
const LABELS = /** @type {Readonly<Record<keyof ShotIdentity, string>>} */ ({
  version: 'the version',
  browser: 'the browser',
  renderer: 'the renderer',
  link: 'the link',
  start: 'the start',
  width: 'the width',
  height: 'the height',
  scale: '--scale',
  supersample: '--supersample',
  fps: '--fps',
  hasBackground: 'the background',
  layers: '--layers',
  format: '--format',
  camera: '--camera',
  loop: '--loop',
  stinger: '--stinger',
});

export class FrameFolder {
  /** @type {Map<string, string>} SHA-256 of the files that were received, by name */
  #received = new Map();
  #folder;
  /** @type {ShotIdentity | undefined} */
  #shot;

  /** @param {string} folder */
  constructor(folder) {
    this.#folder = folder;
  }

  /**
   * @param {readonly number[]} [frames] that this run may write. Default: all
   * @throws {UserError} when the folder cannot be written
   */
  prepare(frames) {
    prepareFolder(this.#folder);
    const own = new Set(frames);
    const isOwn = (/** @type {string} */ name) => !frames || own.has(Number(/(\d{6})\.\w+$/.exec(name)?.[1] ?? -1));
    removeLeftovers(this.#folder, isOwn);
    for (const layer of ['flats', 'shadow', 'ink', 'marks', 'surfaces', 'depth', 'matte']) {
      const folder = join(this.#folder, layer);
      if (existsSync(folder)) removeLeftovers(folder, isOwn);
    }
  }

  /**
   * Compares the frames in the folder with a shot.
   *
   * @param {ShotIdentity} shot
   * @throws {UserError} when the folder has frames of another shot, browser or renderer
   */
  enter(shot) {
    this.#shot = shot;
    for (const name of readdirSync(this.#folder).filter((file) => SIDECAR.test(file))) {
      const found = this.#read(name)?.shot;
      if (found) requireSame(join(this.#folder, name), found, shot);
    }
  }

  /** Whether all files of a frame are as its sidecar says. */
  async isFinished(/** @type {number} */ frame) {
    const sidecar = this.#read(`${stem(frame)}.json`);
    if (!sidecar || sidecar.frame !== frame || Object.keys(sidecar.files ?? {}).length === 0) return false;
    for (const [name, hash] of Object.entries(sidecar.files)) {
      const path = join(this.#folder, name);
      if (!existsSync(path) || (await hashOf(path)) !== hash) return false;
    }
    return true;
  }

  /**
   * @param {string} name of a file of a frame
   * @param {AsyncIterable<Uint8Array>} content
   */
  async receive(name, content) {
    const path = join(this.#folder, name);
    if (dirname(name) !== '.') mkdirSync(dirname(path), { recursive: true });
    this.#received.set(name, await writeWhole(path, content));
  }

  /** @param {{ frame: number, step: number, hash: string }} drawn */
  async finish({ frame, step, hash }) {
    if (!this.#shot) throw new Error('finish() before enter()');
    /** @type {Sidecar} */
    const sidecar = { frame, step, hash, shot: this.#shot, files: Object.fromEntries(this.#received) };
    this.#received.clear();
    await writeWhole(join(this.#folder, `${stem(frame)}.json`), `${JSON.stringify(sidecar, null, 1)}\n`);
  }

  /** The path of a frame's picture. */
  pictureOf(/** @type {number} */ frame) {
    return join(this.#folder, `${stem(frame)}.png`);
  }

  /** @returns {Sidecar | undefined} undefined as well when it is damaged */
  #read(/** @type {string} */ name) {
    try {
      return JSON.parse(readFileSync(join(this.#folder, basename(name)), 'utf8'));
    } catch {
      return undefined;
    }
  }
}

function stem(/** @type {number} */ frame) {
  return `frame-${String(frame).padStart(6, '0')}`;
}

/**
 * @param {string} path of a sidecar
 * @param {ShotIdentity} found
 * @param {ShotIdentity} shot
 */
function requireSame(path, found, shot) {
  for (const [key, label] of Object.entries(LABELS)) {
    const [there, here] = [found, shot].map((each) => JSON.stringify(each[/** @type {keyof ShotIdentity} */ (key)]));
    if (there === here) continue;
    throw new UserError(
      `In ${path}, ${label} is ${there}, here it is ${here}: choose another folder for these frames.`,
    );
  }
}

async function hashOf(/** @type {string} */ path) {
  const hash = createHash('sha256');
  for await (const chunk of createReadStream(path)) hash.update(chunk);
  return hash.digest('hex');
}
