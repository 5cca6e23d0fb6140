/** The npm package in package/, and whether it was built from the sources that lie here. */

import { copyFileSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { inRoot } from '../lib/paths.mjs';
import { digestOf } from './sources.mjs';

export const title = 'Package';
export const FOLDER = 'package';

const SOURCES = ['LICENSE', 'package-lock.json', 'package.json', 'scripts/package', 'shaders', 'src', 'tsconfig.json'];
const STAMP = '.cache/package.txt';

export function isFresh() {
  if (!existsSync(inRoot(`${FOLDER}/package.json`)) || !existsSync(inRoot(STAMP))) return false;
  return readFileSync(inRoot(STAMP), 'utf8') === digestOf(SOURCES);
}

/** @param {(line: string) => void} say */
export async function bring(say) {
  rmSync(inRoot(STAMP), { force: true });
  rmSync(inRoot(FOLDER), { recursive: true, force: true });
  const before = digestOf(SOURCES);
  // They read the parameter table, and need packages that may not have been there before.
  const [{ bundleAll }, { writeLicenses }, { writeTypes }, { customElements }, { manifest }] = await Promise.all([
    import('../package/bundle.mjs'),
    import('../package/licenses.mjs'),
    import('../package/types.mjs'),
    import('../package/customElements.mjs'),
    import('../package/manifest.mjs'),
  ]);
  say('bundling');
  await bundleAll(inRoot(`${FOLDER}/dist`));
  await writeLicenses(inRoot(`${FOLDER}/dist`));
  say('writing declarations');
  await writeTypes(inRoot(`${FOLDER}/types`), say);
  writeFileSync(inRoot(`${FOLDER}/package.json`), `${JSON.stringify(manifest, null, 2)}\n`);
  writeFileSync(inRoot(`${FOLDER}/custom-elements.json`), JSON.stringify(customElements()));
  copyFileSync(inRoot('LICENSE'), inRoot(`${FOLDER}/LICENSE`));
  copyFileSync(inRoot('scripts/package/README.md'), inRoot(`${FOLDER}/README.md`));
  mkdirSync(inRoot('.cache'), { recursive: true });
  writeFileSync(inRoot(STAMP), before);
}
