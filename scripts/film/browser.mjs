/**
 * A browser for one page, over the pipe of the DevTools protocol. Users of the package need no driver such as Playwright
 * for this: the page does its work over HTTP, so the protocol only opens it and notices when it crashes.
 */

import { spawn } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import { homedir } from 'node:os';
import { join } from 'node:path';
import { graphicsFlags, startsAsBrowser, systemBrowsers } from '../lib/chromium.mjs';
import { UserError } from '../lib/userError.mjs';
import { useOwnCores } from './cores.mjs';
import { createProfile, removeProfile } from './profile.mjs';

const MISSING =
  'No browser was found: install Chromium or Chrome, run npx playwright install chromium, or set CHROMIUM_PATH to one.';

/** A browser that was told to close is killed after this time, milliseconds. */
const CLOSE_LIMIT = 3000;

/**
 * The path of a Chromium that starts: $CHROMIUM_PATH, otherwise Playwright's newest, otherwise one of the system.
 *
 * @throws {UserError} when there is none
 */
export function findChromium() {
  const chosen = process.env.CHROMIUM_PATH;
  if (chosen && !startsAsBrowser(chosen)) {
    throw new UserError(`CHROMIUM_PATH is ${chosen}, which does not start as a browser: correct it or unset it.`);
  }
  const path = chosen || [...playwrightBrowsers(), ...systemBrowsers()].find(startsAsBrowser);
  if (!path) throw new UserError(MISSING);
  return path;
}

/** Chromiums that `playwright install` has downloaded, the newest first. */
function playwrightBrowsers() {
  const home = process.env.HOME ?? homedir();
  const folders = [
    process.env.PLAYWRIGHT_BROWSERS_PATH,
    join(home, '.cache/ms-playwright'),
    join(home, 'Library/Caches/ms-playwright'),
    join(process.env.LOCALAPPDATA ?? home, 'ms-playwright'),
  ].filter((folder) => folder !== undefined);
  const programs = [
    'chrome-linux/chrome',
    'chrome-linux64/chrome',
    'chrome-mac/Chromium.app/Contents/MacOS/Chromium',
    'chrome-win/chrome.exe',
    'chrome-win64/chrome.exe',
  ];
  const revision = (/** @type {string} */ name) => Number(name.slice('chromium-'.length));
  return folders
    .filter((folder) => existsSync(folder))
    .flatMap((folder) =>
      readdirSync(folder)
        .filter((name) => /^chromium-\d+$/.test(name))
        .sort((a, b) => revision(b) - revision(a))
        .flatMap((name) => programs.map((program) => join(folder, name, program))),
    );
}

/**
 * @typedef {object} OpenBrowser
 * @property {string} version such as Chrome/149.0.7827.0
 * @property {(address: string) => Promise<void>} show
 * @property {() => void} useOwnCores lets the browser draw on the cores of this process
 * @property {Promise<never>} failure rejects when the browser or its page crashes
 * @property {() => Promise<void>} close
 */

/**
 * Starts a browser without a window.
 *
 * @param {boolean} usesGpu the machine's graphics; $CHROMIUM_ANGLE names another backend of ANGLE
 * @returns {Promise<OpenBrowser>}
 */
export async function openBrowser(usesGpu) {
  const path = findChromium();
  const profile = createProfile();
  const flags = graphicsFlags(usesGpu ? (process.env.CHROMIUM_ANGLE ?? 'default') : 'swiftshader');
  // A group of its own, so that Ctrl+C reaches only this process, which then closes the browser.
  const child = spawn(
    path,
    [...flags, '--headless=new', '--remote-debugging-pipe', `--user-data-dir=${profile}`, 'about:blank'],
    { stdio: ['ignore', 'ignore', 'pipe', 'pipe', 'pipe'], detached: process.platform !== 'win32' },
  );
  let output = '';
  child.stderr?.setEncoding('utf8').on('data', (text) => (output = `${output}${text}`.slice(-2000)));
  const ended = new Promise((resolve) => child.once('close', resolve));
  const protocol = new Protocol(
    /** @type {import('node:stream').Writable} */ (child.stdio[3]),
    /** @type {import('node:stream').Readable} */ (child.stdio[4]),
  );
  const failure = /** @type {Promise<never>} */ (
    new Promise((_, reject) => {
      const fail = (/** @type {string} */ what) => reject(new UserError(`${what} (${path}).`, output));
      child.once('error', (error) => fail(`The browser did not start: ${error.message}`));
      child.once('exit', () => fail('The browser ended'));
      protocol.on('Target.targetCrashed', () => fail('The page of the browser crashed, perhaps for lack of memory'));
    })
  );
  // Whoever waits for it gets the error; nobody does after close().
  failure.catch(() => undefined);
  const close = async () => {
    child.removeAllListeners('exit');
    // A browser that is killed at once leaves files outside its profile.
    protocol.send('Browser.close').catch(() => undefined);
    const timer = setTimeout(() => kill(child), CLOSE_LIMIT);
    await ended;
    clearTimeout(timer);
    removeProfile(profile);
  };
  try {
    const version = await Promise.race([protocol.send('Browser.getVersion'), failure]);
    await protocol.send('Target.setDiscoverTargets', { discover: true });
    return {
      version: String(version.product).replace(/^Headless/, ''),
      show: async (address) => {
        await Promise.race([protocol.send('Target.createTarget', { url: address }), failure]);
      },
      useOwnCores: () => useOwnCores(Number(child.pid)),
      failure,
      close,
    };
  } catch (error) {
    await close();
    throw error;
  }
}

/** Ends the browser with its processes. */
function kill(/** @type {import('node:child_process').ChildProcess} */ child) {
  try {
    if (process.platform === 'win32' || child.pid === undefined) child.kill('SIGKILL');
    else process.kill(-child.pid, 'SIGKILL');
  } catch {
    // It has ended.
  }
}

/** The DevTools protocol over a pipe: JSON texts that end with a zero. */
class Protocol {
  #last = 0;
  #rest = '';
  /** @type {Map<number, { resolve: (result: Record<string, unknown>) => void, reject: (error: Error) => void }>} */
  #waiting = new Map();
  /** @type {Map<string, () => void>} */
  #listeners = new Map();
  #input;

  /**
   * @param {import('node:stream').Writable} input of the browser
   * @param {import('node:stream').Readable} output of the browser
   */
  constructor(input, output) {
    this.#input = input;
    // Writing to a browser that has ended is reported by its exit.
    input.on('error', () => undefined);
    output.setEncoding('utf8').on('data', (/** @type {string} */ text) => this.#read(text));
  }

  /**
   * @param {string} method
   * @param {Record<string, unknown>} [params]
   * @returns {Promise<Record<string, unknown>>}
   */
  send(method, params = {}) {
    const id = ++this.#last;
    this.#input.write(`${JSON.stringify({ id, method, params })}\0`);
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }

  /**
   * @param {string} event
   * @param {() => void} listener
   */
  on(event, listener) {
    this.#listeners.set(event, listener);
  }

  #read(/** @type {string} */ text) {
    const messages = (this.#rest + text).split('\0');
    this.#rest = messages.pop() ?? '';
    for (const message of messages) {
      const { id, method, result, error } = JSON.parse(message);
      if (method) this.#listeners.get(method)?.();
      const waiting = this.#waiting.get(id);
      this.#waiting.delete(id);
      if (error) waiting?.reject(new Error(error.message));
      else waiting?.resolve(result);
    }
  }
}
