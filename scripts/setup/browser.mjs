/**
 * The Chromium that the tests and benchmarks run in: $CHROMIUM_PATH, else Playwright's own, else one of the system,
 * else what `playwright install` downloads, else the system's package, which takes root and apt-get.
 */

import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { run } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';

export const title = 'Browser for the tests';

// What Playwright turns off stays off: of two such flags a browser reads the last alone.
const OFF_FOR_PLAYWRIGHT = [
  'AvoidUnnecessaryBeforeUnloadCheckSync',
  'DestroyProfileOnBrowserClose',
  'HttpsUpgrades',
  'HttpsFirstBalancedModeAutoEnable',
  'LensOverlay',
  'MediaRouter',
  'PaintHolding',
  'ThirdPartyStoragePartitioning',
  'AvoidCorsURLLoaderRestartOnRedirect',
  'TcpPortRandomizationWin',
  'OptimizationHints',
  'NetworkTimeServiceQuerying',
  'AimEnabled',
  'PreconnectToSearch',
  'msForceBrowserSignIn',
  'msEdgeUpdateLaunchServicesPreferredVersion',
];
// Pages behind the address field, which nobody sees and each window loads: a third of what a test's page takes.
const ADDRESS_FIELD = ['WebUIOmniboxPopup', 'WebUIOmniboxAimPopup'];

/** Pin the rasteriser to SwiftShader, so that pictures are the same on every machine, and keep the browser quiet. */
export const CHROMIUM_FLAGS = [
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  // A context finds the shaders that another one has compiled, which is most of what a small picture takes.
  '--enable-angle-features=preferGlobalPipelineCache',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--no-first-run',
  `--disable-features=${[...OFF_FOR_PLAYWRIGHT, ...ADDRESS_FIELD].join()}`,
  // Chromium's sandbox refuses to run for root, which is what containers are.
  ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
];

const NAMES = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'chrome'];
const APPLICATIONS = [
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
];
const DOWNLOAD_LIMIT = 10 * 60_000;

/** @type {string | undefined} */
let found;

/**
 * The path of a Chromium that starts, or undefined. Needs the Node packages.
 *
 * @throws {UserError} when $CHROMIUM_PATH is set and does not lead to one
 */
export async function findBrowser() {
  if (found) return found;
  const chosen = process.env.CHROMIUM_PATH;
  if (chosen && !starts(chosen)) {
    throw new UserError(
      `CHROMIUM_PATH is ${chosen}, which does not start as a browser: correct it or unset it, then try again.`,
    );
  }
  found = chosen || [await playwrightBrowser(), ...systemBrowsers()].find((path) => path && starts(path));
  return found;
}

/**
 * The path of Debian's headless shell, which shows pages for less CPU time than the whole browser, or undefined. It
 * has no windows, so no tab hides another.
 */
export function findShell() {
  return programsOnPath(['chromium-headless-shell']).find((path) => starts(path));
}

export async function isFresh() {
  return (await findBrowser()) !== undefined;
}

/** @param {(line: string) => void} say */
export async function bring(say) {
  const download = await playwright(['install', 'chromium'], say);
  if (await isFresh()) return;
  if (isDebianRoot()) {
    // A downloaded browser that does not start lacks libraries of the system.
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

/** Runs a command of Playwright's. @param {string[]} parameters @param {(line: string) => void} say */
export function playwright(parameters, say) {
  const script = inRoot('node_modules/playwright/cli.js');
  // Playwright waits half a minute for each of several mirrors, thrice: a machine without a network should learn sooner.
  const environment = { PLAYWRIGHT_DOWNLOAD_CONNECTION_TIMEOUT: '15000' };
  return run(process.execPath, [script, ...parameters], { environment, onLine: say, limit: DOWNLOAD_LIMIT });
}

/** Whether packages of the system can be installed. */
export function isDebianRoot() {
  return process.getuid?.() === 0 && existsSync('/etc/debian_version');
}

/** Installs packages of Debian, as root. @param {string[]} packages @param {(line: string) => void} say */
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

function systemBrowsers() {
  return [...programsOnPath(NAMES), ...APPLICATIONS];
}

/** Where these programs may lie, the first name first. */
function programsOnPath(/** @type {string[]} */ names) {
  const folders = (process.env.PATH ?? '').split(delimiter).filter(Boolean);
  return names.flatMap((name) => folders.map((folder) => join(folder, name)));
}

/** Some systems have a `chromium` that only tells where to get one, so being there is not enough. */
function starts(/** @type {string} */ path) {
  if (!existsSync(path)) return false;
  const { status, stdout } = spawnSync(path, ['--version'], { encoding: 'utf8', timeout: 30_000 });
  return status === 0 && /chrom/i.test(stdout);
}

/** What a tool said last about its failure. */
export function lastLine(/** @type {string} */ output) {
  const lines = output.split('\n').filter((line) => line.trim());
  return (
    lines.find((line) => /^(E:|Error|error)/.test(line.trim()))?.trim() ?? lines.at(-1)?.trim() ?? 'no reason given'
  );
}
