/**
 * Chromium for the tests and benchmarks: $CHROMIUM_PATH, otherwise Playwright's, otherwise one of the system, otherwise
 * a download by `playwright install`, otherwise the system's package, which requires root and apt-get.
 */

import { existsSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { graphicsFlags, programsOnPath, startsAsBrowser, systemBrowsers } from '../lib/chromium.mjs';
import { run, runScript } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';

export const title = 'Browser for the tests';

/** Render with SwiftShader, so that pictures are the same on every machine, and disable background activity. */
export const CHROMIUM_FLAGS = graphicsFlags();

const DOWNLOAD_LIMIT = 10 * 60_000;

/** @type {string | undefined} */
let found;

/**
 * The path of a Chromium that starts, or undefined. Requires the Node packages.
 *
 * @throws {UserError} when $CHROMIUM_PATH is set and is not a working Chromium
 */
export async function findBrowser() {
  if (found) return found;
  const chosen = process.env.CHROMIUM_PATH;
  if (chosen && !startsAsBrowser(chosen)) {
    throw new UserError(
      `CHROMIUM_PATH is ${chosen}, which does not start as a browser: correct it or unset it, then try again.`,
    );
  }
  found = chosen || [await playwrightBrowser(), ...systemBrowsers()].find((path) => path && startsAsBrowser(path));
  return found;
}

/**
 * The path of Debian's headless shell, or undefined. It uses less CPU time than the full browser, and it has no
 * windows, so tabs do not hide each other.
 */
export function findShell() {
  return programsOnPath(['chromium-headless-shell']).find((path) => startsAsBrowser(path));
}

export async function isFresh() {
  return (await findBrowser()) !== undefined;
}

/** @param {(line: string) => void} say */
export async function bring(say) {
  const download = await playwright(['install', 'chromium'], say);
  if (await isFresh()) return;
  if (isDebianRoot()) {
    // A downloaded browser that does not start lacks system libraries.
    const hasOwn = existsSync((await playwrightBrowser()) ?? '');
    const outcome = hasOwn
      ? await playwright(['install-deps', 'chromium'], say)
      : await aptGet(['chromium', 'chromium-headless-shell'], say);
    if (await isFresh()) return;
    throw browserError(`apt-get: ${lastLine(outcome.output)}`);
  }
  throw browserError(`playwright install: ${lastLine(download.output)}`);
}

function browserError(/** @type {string} */ reason) {
  return new UserError(
    `No Chromium was found and none could be installed (${reason}): install Chromium or Chrome, or set CHROMIUM_PATH, then try again.`,
  );
}

/**
 * Runs a Playwright command.
 * @param {string[]} parameters
 * @param {(line: string) => void} say
 */
export function playwright(parameters, say) {
  // Playwright waits 30 s for each of several mirrors, three times. Without a network, it should fail sooner.
  const environment = { PLAYWRIGHT_DOWNLOAD_CONNECTION_TIMEOUT: '15000' };
  const options = { environment, onLine: say, limit: DOWNLOAD_LIMIT };
  return runScript('node_modules/playwright/cli.js', parameters, options);
}

/** Whether system packages can be installed. */
export function isDebianRoot() {
  return process.getuid?.() === 0 && existsSync('/etc/debian_version');
}

/**
 * Installs Debian packages, as root.
 * @param {string[]} packages
 * @param {(line: string) => void} say
 */
export async function aptGet(packages, say) {
  const options = { environment: { DEBIAN_FRONTEND: 'noninteractive' }, onLine: say, limit: DOWNLOAD_LIMIT };
  await run('apt-get', ['update'], options);
  return run('apt-get', ['install', '--yes', '--no-install-recommends', ...packages], options);
}

async function playwrightBrowser() {
  const script = inRoot('node_modules/playwright-core/index.mjs');
  if (!existsSync(script)) return undefined;
  const { chromium } = await import(pathToFileURL(script).href);
  return /** @type {string} */ (chromium.executablePath());
}

/** The last error line of a tool's output. */
export function lastLine(/** @type {string} */ output) {
  const lines = output.split('\n').filter((line) => line.trim());
  return (
    lines.find((line) => /^(E:|Error|error)/.test(line.trim()))?.trim() ?? lines.at(-1)?.trim() ?? 'no reason given'
  );
}
