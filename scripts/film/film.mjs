/** Renders a shot to files: opens the film page in a browser and keeps what it sends. */

import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { withProgress } from '../lib/progress.mjs';
import { UserError } from '../lib/userError.mjs';
import { openBrowser } from './browser.mjs';
import { removeParts, writeWhole } from './files.mjs';
import { FrameFolder } from './frames.mjs';
import { readFilmOptions } from './options.mjs';
import { servePage } from './server.mjs';
import { StateFolder } from './states.mjs';
import { encodeByFfmpeg, requireFfmpeg } from './video.mjs';

/** The page has to answer within this time, milliseconds; a slow machine compiles its shaders for minutes later. */
const START_LIMIT = 180_000;

/**
 * @typedef {import('./options.mjs').FilmOptions} FilmOptions
 * @typedef {import('./server.mjs').PageFiles} PageFiles
 * @typedef {import('../../src/app/film/order.ts').DrawnFrame} DrawnFrame
 */

/**
 * `cartoon-smoke film`.
 *
 * @param {string[]} words after `film`
 * @param {PageFiles} files of the page
 * @param {string} version of the package
 * @param {(drawn: DrawnFrame) => void} [onFrame]
 * @returns {Promise<number>} the exit status
 */
export async function film(words, files, version, onFrame) {
  const options = readFilmOptions(words);
  if (options.video?.type === 'mov') requireFfmpeg();
  const folder = new FrameFolder(options.out);
  await folder.prepare(options.frames);
  const states = options.states === undefined ? undefined : new StateFolder(options.states);
  await states?.prepare();
  const session = new Session(options, folder, states, files, `${version}+${digestOf(files)}`, onFrame);
  const stopped = stopSignal();
  try {
    const outcome = await withProgress('Film', (say) => Promise.race([session.run(say), stopped]), summaryOf);
    return typeof outcome === 'number' ? outcome : 0;
  } finally {
    await session.close();
    removeParts();
  }
}

function summaryOf(/** @type {string | number} */ outcome) {
  return typeof outcome === 'number' ? 'stopped' : outcome;
}

class Session {
  #options;
  #folder;
  #states;
  #files;
  #version;
  #onFrame;
  /** @type {(() => void | Promise<void>)[]} */
  #closing = [];
  /** @type {import('../../src/app/film/order.ts').Beginning | undefined} */
  #beginning;
  #browser = '';
  #finished = 0;
  #drawn = 0;
  #beganAt = 0;
  /** @type {(line: string) => void} */
  #say = () => undefined;
  /** @type {() => void} */
  #resolve = () => undefined;
  /** @type {(error: unknown) => void} */
  #reject = () => undefined;

  /**
   * @param {FilmOptions} options
   * @param {FrameFolder} folder
   * @param {StateFolder | undefined} states
   * @param {PageFiles} files
   * @param {string} version
   * @param {((drawn: DrawnFrame) => void) | undefined} onFrame
   */
  constructor(options, folder, states, files, version, onFrame) {
    this.#options = options;
    this.#folder = folder;
    this.#states = states;
    this.#files = files;
    this.#version = version;
    this.#onFrame = onFrame;
  }

  /**
   * @param {(line: string) => void} say
   * @returns {Promise<string>} a summary
   */
  async run(say) {
    this.#say = say;
    const browser = await openBrowser(this.#options.usesGpu);
    this.#closing.push(() => browser.close());
    this.#browser = browser.version;
    const server = await servePage(this.#files, (request) => this.#answer(request));
    this.#closing.push(() => server.close());
    const done = new Promise((resolve, reject) => {
      this.#resolve = () => resolve(undefined);
      this.#reject = reject;
    });
    const timer = setTimeout(() => {
      if (!this.#beginning) this.#reject(new UserError('The browser did not open the page in time. Try again.'));
    }, START_LIMIT);
    this.#closing.push(() => clearTimeout(timer));
    await browser.show(server.address);
    await Promise.race([done, browser.failure]);
    const { video, first, last, out, order, frames } = this.#options;
    if (video?.type === 'mov') await encodeByFfmpeg(video.file, { folder: out, first, last, fps: order.fps });
    const { length } = frames;
    const reused = length - this.#drawn;
    return `${this.#drawn} frames drawn${reused > 0 ? `, ${reused} were finished before` : ''}`;
  }

  async close() {
    for (const close of this.#closing.toReversed()) await close();
    this.#closing = [];
  }

  /** @type {import('./server.mjs').Answerer} */
  async #answer(request) {
    try {
      return await this.#reply(request);
    } catch (error) {
      this.#reject(error);
      throw error;
    }
  }

  /** @type {import('./server.mjs').Answerer} */
  async #reply({ method, path, body, headers }) {
    const [what, ...rest] = path.split('/');
    const name = rest.join('/');
    switch (`${method} ${what}`) {
      case 'GET order':
        return { body: JSON.stringify(this.#order()) };
      case 'POST begin':
        return { body: JSON.stringify(await this.#begin(await jsonOf(body))) };
      case 'PUT file':
        if (!/^(frame-|[a-z]+\/)\d{4,}\.(png|exr)$/.test(name)) return undefined;
        await this.#folder.receive(name, body);
        return {};
      case 'POST finish':
        await this.#finish(await jsonOf(body));
        return {};
      case 'GET state': {
        const state = this.#states?.latest(Number(name));
        return state ? { body: state.bytes, headers: { 'x-hash': state.hash } } : {};
      }
      case 'PUT state':
        await this.#states?.save(Number(name), String(headers['x-hash']), await bytesOf(body));
        return {};
      case 'GET picture':
        return { body: { file: this.#folder.pictureOf(Number(name)) }, headers: { 'content-type': 'image/png' } };
      case 'PUT video':
        if (!this.#options.video) return undefined;
        await writeWhole(this.#options.video.file, body);
        return {};
      case 'POST end':
        this.#resolve();
        return {};
      case 'POST fail':
        throw new UserError((await bytesOf(body)).toString('utf8'));
      default:
        return undefined;
    }
  }

  #order() {
    const { order, video, first, last } = this.#options;
    return video && video.type !== 'mov' ? { ...order, video: { format: video.type, first, last } } : order;
  }

  /** @param {import('../../src/app/film/order.ts').Beginning} beginning */
  async #begin(beginning) {
    this.#beginning = beginning;
    const { order, frames } = this.#options;
    const { statesEvery: _, ...shot } = order;
    const { link, start, renderer } = beginning;
    this.#folder.enter({ ...shot, link, start, version: this.#version, browser: this.#browser, renderer });
    this.#states?.enter({ link, version: this.#version });
    const missing = [];
    for (const frame of frames) if (!(await this.#folder.isFinished(frame))) missing.push(frame);
    this.#finished = frames.length - missing.length;
    this.#beganAt = Date.now();
    this.#say(`${this.#finished} of ${frames.length} frames are finished`);
    return missing;
  }

  async #finish(/** @type {DrawnFrame} */ drawn) {
    await this.#folder.finish(drawn);
    this.#onFrame?.(drawn);
    const { length } = this.#options.frames;
    this.#drawn++;
    this.#finished++;
    const minutes = (Date.now() - this.#beganAt) / 60_000;
    const left = ((length - this.#finished) * minutes) / this.#drawn;
    this.#say(
      `frame ${drawn.frame}, ${this.#finished} of ${length} are finished, ` +
        `${(this.#drawn / minutes).toFixed(1)} a minute, ${durationOf(left)} left`,
    );
  }
}

/** Resolves to the exit status when the user or a scheduler stops the command. */
function stopSignal() {
  return new Promise((/** @type {(status: number) => void} */ resolve) => {
    for (const [signal, status] of /** @type {const} */ ([
      ['SIGINT', 130],
      ['SIGTERM', 143],
      ['SIGHUP', 129],
    ])) {
      // Others end the process at once, before files and browser are closed.
      process.removeAllListeners(signal);
      process.on(signal, () => {
        console.error('Stopped. The finished frames are complete; the same command continues with the others.');
        resolve(status);
      });
    }
  });
}

/** Identifies the build, so that frames and states of two builds are not mixed. */
function digestOf(/** @type {PageFiles} */ { page, wasm }) {
  const hash = createHash('sha256');
  for (const folder of [page, wasm]) {
    const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) =>
      /\.(js|wasm)$/.test(name),
    );
    for (const name of files.sort()) hash.update(readFileSync(join(folder, name)));
  }
  return hash.digest('hex').slice(0, 12);
}

function durationOf(/** @type {number} */ minutes) {
  if (minutes < 1) return `${Math.round(60 * minutes)} s`;
  return minutes < 90 ? `${Math.round(minutes)} min` : `${(minutes / 60).toFixed(1)} h`;
}

/** @param {AsyncIterable<Uint8Array>} body */
async function bytesOf(body) {
  const chunks = [];
  for await (const chunk of body) chunks.push(chunk);
  return Buffer.concat(chunks);
}

/** @param {AsyncIterable<Uint8Array>} body */
async function jsonOf(body) {
  return JSON.parse((await bytesOf(body)).toString('utf8'));
}
