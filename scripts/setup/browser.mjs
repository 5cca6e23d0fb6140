/**
 * Chromium for the tests and benchmarks: $CHROMIUM_PATH, otherwise Playwright's, otherwise one of the system, otherwise
 * a download by `playwright install`, otherwise the system's package, which requires root and apt-get.
 */

import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { run, runScript } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';

export const title = 'Browser for the tests';

// Features that Playwright disables. They must be repeated, because a browser uses only the last --disable-features
// flag.
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
// Pages behind the address bar, which are never visible and load in each window: a third of the cost of a test page.
const ADDRESS_FIELD = ['WebUIOmniboxPopup', 'WebUIOmniboxAimPopup'];

const COMMON_FLAGS = [
  // Contexts share compiled shaders. Compilation is most of the time of a small picture.
  '--enable-angle-features=preferGlobalPipelineCache',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--no-first-run',
  `--disable-features=${[...OFF_FOR_PLAYWRIGHT, ...ADDRESS_FIELD].join()}`,
  // Chromium's sandbox does not run as root, the default user in containers.
  ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
];

/** Render with SwiftShader, so that pictures are the same on every machine, and disable background activity. */
export const CHROMIUM_FLAGS = graphicsFlags();

/**
 * Chromium's flags for a backend of ANGLE.
 *
 * @param {string} [backend] swiftshader, vulkan, gl, metal or d3d11
 */
export function graphicsFlags(backend = 'swiftshader') {
  const own = backend === 'swiftshader' ? ['--enable-unsafe-swiftshader'] : ['--ignore-gpu-blocklist', '--enable-gpu'];
  const vulkan = backend === 'vulkan' ? ['--enable-features=Vulkan', '--disable-vulkan-surface'] : [];
  return ['--use-gl=angle', `--use-angle=${backend}`, ...own, ...vulkan, ...COMMON_FLAGS];
}

const NAMES = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'chrome'];
const APPLICATIONS = [
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
];
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
  if (chosen && !starts(chosen)) {
    throw new UserError(
      `CHROMIUM_PATH is ${chosen}, which does not start as a browser: correct it or unset it, then try again.`,
    );
  }
  found = chosen || [await playwrightBrowser(), ...systemBrowsers()].find((path) => path && starts(path));
  return found;
}

/**
 * The path of Debian's headless shell, or undefined. It uses less CPU time than the full browser, and it has no
 * windows, so tabs do not hide each other.
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

function systemBrowsers() {
  return [...programsOnPath(NAMES), ...APPLICATIONS];
}

/** Candidate paths on PATH, in the order of the names. */
function programsOnPath(/** @type {string[]} */ names) {
  const folders = (process.env.PATH ?? '').split(delimiter).filter(Boolean);
  return names.flatMap((name) => folders.map((folder) => join(folder, name)));
}

/** Some systems have a `chromium` stub that only prints installation instructions, so the file must also run. */
function starts(/** @type {string} */ path) {
  if (!existsSync(path)) return false;
  const { status, stdout } = spawnSync(path, ['--version'], { encoding: 'utf8', timeout: 30_000 });
  return status === 0 && /chrom/i.test(stdout);
}

/** The last error line of a tool's output. */
export function lastLine(/** @type {string} */ output) {
  const lines = output.split('\n').filter((line) => line.trim());
  return (
    lines.find((line) => /^(E:|Error|error)/.test(line.trim()))?.trim() ?? lines.at(-1)?.trim() ?? 'no reason given'
  );
}
