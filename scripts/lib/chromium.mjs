/** Chromium on this machine: where it may be, whether it starts, and its flags. */

import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';

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

/** Paths at which a Chromium or Chrome may be installed. */
export function systemBrowsers() {
  return [...programsOnPath(NAMES), ...APPLICATIONS];
}

/** Candidate paths on PATH, in the order of the names. */
export function programsOnPath(/** @type {string[]} */ names) {
  const folders = (process.env.PATH ?? '').split(delimiter).filter(Boolean);
  return names.flatMap((name) => folders.map((folder) => join(folder, name)));
}

/** Some systems have a `chromium` stub that only prints installation instructions, so the file must also run. */
export function startsAsBrowser(/** @type {string} */ path) {
  if (!existsSync(path)) return false;
  const { status, stdout } = spawnSync(path, ['--version'], { encoding: 'utf8', timeout: 30_000 });
  return status === 0 && /chrom/i.test(stdout);
}
