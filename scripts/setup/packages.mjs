/** The Node packages of the lock files. */

import { existsSync, readFileSync } from 'node:fs';
import { run } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';

/** npm tries each download three times. Without a network, it should fail within a minute. */
const RETRIES = ['--fetch-retry-mintimeout=2000', '--fetch-retry-maxtimeout=8000'];

/**
 * @typedef {{ version: string, integrity?: string, optional?: boolean, link?: boolean }} Package
 * @typedef {Record<string, Package>} Packages by path, like `node_modules/three`
 */

/** The packages of the repository itself. */
export const { title, isFresh, bring } = packagesIn('.', 'Node packages');

/**
 * The packages of a folder with a lock file.
 *
 * @param {string} folder in the repository
 * @param {string} name of the component
 */
export function packagesIn(folder, name) {
  return {
    title: name,
    isFresh: () => isInstalled(folder),
    bring: (/** @type {(line: string) => void} */ say) => install(folder, say),
  };
}

/** Whether node_modules is what `npm ci` would install from the lock file. */
function isInstalled(/** @type {string} */ folder) {
  const wanted = readPackages(`${folder}/package-lock.json`);
  // npm writes its hidden lock file last, so an interrupted installation has none.
  const found = readPackages(`${folder}/node_modules/.package-lock.json`);
  if (!wanted || !found) return false;
  const isUnchanged = Object.entries(wanted).every(([path, entry]) => {
    const same = found[path]?.version === entry.version && found[path]?.integrity === entry.integrity;
    // Most optional packages are binaries for other platforms, which npm skips.
    return found[path] ? same && existsSync(inRoot(`${folder}/${path}`)) : Boolean(entry.optional);
  });
  return isUnchanged && Object.keys(found).every((path) => path in wanted);
}

/** @param {string} folder @param {(line: string) => void} say */
async function install(folder, say) {
  let fetched = 0;
  const outcome = await runNpm(['ci', '--no-audit', '--no-fund', '--loglevel=http', ...RETRIES], {
    folder: inRoot(folder),
    onLine: (line) => say(/http fetch GET 200/.test(line) ? `${++fetched} files fetched` : line),
  });
  if (outcome.status === 0) return;
  if (outcome.status === 127)
    throw new UserError('npm was not found: install it with Node from https://nodejs.org, then try again.');
  if (/code EUSAGE/.test(outcome.output)) {
    throw new UserError('package-lock.json does not match package.json: run npm install, then try again.');
  }
  throw new UserError(
    `npm ci could not install the packages (${reason(outcome.output)}): check the network and npm's registry setting, then try again.`,
  );
}

/**
 * Runs the npm that started this process, if any: a bare `npm` is a script on some systems.
 *
 * @param {readonly string[]} parameters
 * @param {Parameters<typeof run>[2]} options
 */
export function runNpm(parameters, options) {
  const script = process.env.npm_execpath;
  if (script?.endsWith('.js') && existsSync(script)) return run(process.execPath, [script, ...parameters], options);
  return run('npm', parameters, options);
}

/** @returns {Packages | undefined} */
function readPackages(/** @type {string} */ path) {
  if (!existsSync(inRoot(path))) return undefined;
  const { '': _project, ...packages } = JSON.parse(readFileSync(inRoot(path), 'utf8')).packages;
  return packages;
}

/** The line about the network request in npm's error output, otherwise the first line. */
function reason(/** @type {string} */ output) {
  const errors = [...output.matchAll(/^npm (?:error|ERR!) (.+)$/gm)].map((match) => match[1].trim());
  return errors.find((line) => /request to|network/.test(line)) ?? errors[0] ?? 'no reason given';
}
