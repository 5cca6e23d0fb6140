/** The pages of the API, which TypeDoc writes from the sources of the package. */

import { cpSync, existsSync, readFileSync, rmSync } from 'node:fs';
import { runScript } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';
import { digestOf } from '../setup/sources.mjs';
import { PAGES, write } from './documents.mjs';

const CACHE = '.cache/docs/api';
const SOURCES = ['site/package-lock.json', 'site/typedoc.json', 'site/typedoc.tsconfig.json', 'src'];

/**
 * @param {boolean} isMade whether to run TypeDoc if its pages are missing
 * @param {(line: string) => void} say
 * @returns {Promise<boolean>} whether there are pages
 */
export async function writeApi(isMade, say) {
  const folder = `${CACHE}/${digestOf(SOURCES).slice(0, 16)}`;
  if (!existsSync(inRoot(`${folder}/index.md`))) {
    if (!isMade) return false;
    rmSync(inRoot(CACHE), { recursive: true, force: true });
    const parameters = ['--options', 'typedoc.json', '--out', inRoot(folder)];
    const options = { folder: inRoot('site'), onLine: say };
    const { status, output } = await runScript('site/node_modules/typedoc/bin/typedoc', parameters, options);
    if (status !== 0) throw new UserError(`TypeDoc could not write the pages of the API:\n${output}`);
  }
  cpSync(inRoot(folder), inRoot(`${PAGES}/api`), { recursive: true });
  // TypeDoc names the entries after their files.
  const index = readFileSync(inRoot(`${folder}/index.md`), 'utf8');
  const named = index.replace(
    /^- \[(\w+)\]/gm,
    (_, file) => `- [\`cartoon-smoke${file === 'index' ? '' : `/${file}`}\`]`,
  );
  write('api/index.md', named);
  return true;
}
