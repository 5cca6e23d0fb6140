/**
 * Firefox and WebKit for `npm run test:engines`: Playwright's builds if they are installed and start, otherwise
 * Debian's packages, which are installed if this process runs as root.
 */

import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';
import { aptGet, isDebianRoot, lastLine, playwright } from './browser.mjs';

/**
 * @typedef {import('./setup.mjs').Component} Component
 * @typedef {object} Engine
 * @property {'firefox' | 'webkit'} name
 * @property {boolean} isPlaywrights whether Playwright drives it; otherwise it is Debian's, under Xvfb with Mesa's
 * llvmpipe
 * @property {string} path of the browser; for Debian's WebKit, of MiniBrowser
 */

// Mesa's software renderer, and a virtual display.
const DISPLAY = ['xvfb', 'libgl1-mesa-dri', 'libglx-mesa0', 'libgl1', 'libegl1', 'libegl-mesa0', 'libgles2', 'libpci3'];
const PACKAGES = { firefox: ['firefox-esr', ...DISPLAY], webkit: ['webkit2gtk-driver', ...DISPLAY] };

/** @type {(name: Engine['name'], title: string) => Component & { find(): Promise<Engine | undefined> }} */
function engine(name, title) {
  const find = async () => (await findPlaywrights(name)) ?? findDebians(name);
  return {
    title,
    find,
    isFresh: async () => (await find()) !== undefined,
    bring: async (say) => {
      const attempts = [
        ...(isDebianRoot() ? [() => aptGet(PACKAGES[name], say)] : []),
        () => playwright(['install', name], say),
      ];
      const reasons = [];
      for (const attempt of attempts) {
        const { output } = await attempt();
        if (await find()) return;
        reasons.push(lastLine(output));
      }
      throw new UserError(`${title} could not be installed (${reasons.join('; ')}).`);
    },
  };
}

export const ENGINES = [engine('firefox', 'Firefox'), engine('webkit', 'WebKit')];

/**
 * @param {Engine['name']} name
 * @returns {Promise<Engine | undefined>}
 */
async function findPlaywrights(name) {
  const { [name]: type } = await import(pathToFileURL(inRoot('node_modules/playwright-core/index.mjs')).href);
  const path = type.executablePath();
  if (!existsSync(path)) return undefined;
  try {
    await (await type.launch()).close();
  } catch {
    return undefined;
  }
  return { name, isPlaywrights: true, path };
}

/**
 * @param {Engine['name']} name
 * @returns {Engine | undefined}
 */
function findDebians(name) {
  const asked = spawnSync('dpkg-query', ['--show', '--showformat=${db:Status-Status}\n', ...PACKAGES[name]]);
  if (asked.status !== 0 || /not-installed|config-files/.test(String(asked.stdout))) return undefined;
  const path = name === 'firefox' ? '/usr/bin/firefox-esr' : findMiniBrowser();
  return path && existsSync(path) ? { name, isPlaywrights: false, path } : undefined;
}

/** The path depends on the architecture and the WebKitGTK version. */
function findMiniBrowser() {
  const asked = spawnSync('dpkg-query', ['--search', '*/MiniBrowser'], { encoding: 'utf8' });
  return /: (\/.+)$/m.exec(asked.stdout)?.[1];
}
