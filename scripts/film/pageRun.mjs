/** Opens the film page in a browser and answers it until it has ended. */

import { UserError } from '../lib/userError.mjs';
import { withProgress } from '../lib/progress.mjs';
import { openBrowser } from './browser.mjs';
import { removeParts } from './files.mjs';
import { servePage } from './server.mjs';

/** The page has to ask for its order within this time, milliseconds. */
const START_LIMIT = 180_000;

export class PageRun {
  /** @type {(() => void | Promise<void>)[]} */
  #closing = [];
  #isClosed = false;
  #hasBegun = false;
  /** Version of the browser, once the page asks. */
  browser = '';

  /**
   * @param {import('./server.mjs').PageFiles} files
   * @param {boolean} usesGpu
   * @param {import('./server.mjs').Answerer} reply answers all requests but `end` and `fail`; its first error ends the
   * run
   * @returns {Promise<void>}
   */
  async run(files, usesGpu, reply) {
    const browser = await openBrowser(usesGpu);
    this.browser = browser.version;
    // Stopped while the browser started.
    if (this.#isClosed) return browser.close();
    this.#closing.push(() => browser.close());
    const { promise: ended, resolve, reject } = deferred();
    let drawsOnOwnCores = false;
    const server = await servePage(files, async (request) => {
      this.#hasBegun = true;
      try {
        // Since its request for the order, the page has created what draws.
        if (request.path !== 'order' && !drawsOnOwnCores) {
          drawsOnOwnCores = true;
          browser.useOwnCores();
        }
        if (request.path === 'end') resolve();
        else if (request.path === 'fail') throw new UserError((await bytesOf(request.body)).toString('utf8'));
        else return await reply(request);
        return {};
      } catch (error) {
        reject(error);
        throw error;
      }
    });
    this.#closing.push(() => server.close());
    const timer = setTimeout(() => {
      if (!this.#hasBegun) reject(new UserError('The browser did not open the page in time. Try again.'));
    }, START_LIMIT);
    this.#closing.push(() => clearTimeout(timer));
    await browser.show(server.address);
    await Promise.race([ended, browser.failure]);
  }

  async close() {
    this.#isClosed = true;
    for (const close of this.#closing.toReversed()) await close();
    this.#closing = [];
  }
}

/**
 * Runs a command to its end, or until the user or a scheduler stops it. Leaves no browser and no part of a file.
 *
 * @param {string} title
 * @param {PageRun} page
 * @param {(say: (line: string) => void) => Promise<string>} work resolves to a summary
 * @returns {Promise<number>} the exit status
 */
export async function untilStopped(title, page, work) {
  const stopped = stopSignal();
  try {
    const outcome = await withProgress(title, (say) => Promise.race([work(say), stopped]), summaryOf);
    return typeof outcome === 'number' ? outcome : 0;
  } finally {
    await page.close();
    removeParts();
  }
}

function summaryOf(/** @type {string | number} */ outcome) {
  return typeof outcome === 'number' ? 'stopped' : outcome;
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
        console.error('Stopped. Finished files are complete; the same command continues with the others.');
        resolve(status);
      });
    }
  });
}

function deferred() {
  let resolve = () => {};
  let reject = (/** @type {unknown} */ _error) => {};
  const promise = /** @type {Promise<void>} */ (
    new Promise((onResult, onError) => {
      resolve = () => onResult(undefined);
      reject = onError;
    })
  );
  // Whoever waits for it gets the error; nobody does before the page is open.
  promise.catch(() => undefined);
  return { promise, resolve, reject };
}

/** @param {AsyncIterable<Uint8Array>} body */
export async function bytesOf(body) {
  const chunks = [];
  for await (const chunk of body) chunks.push(chunk);
  return Buffer.concat(chunks);
}
