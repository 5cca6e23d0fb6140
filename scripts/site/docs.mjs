/** Builds docs/ as a site with VitePress, whose packages are in site/. */

import { existsSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { runScript } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';
import { writeScriptLicenses } from '../package/licenses.mjs';
import { writeApi } from './api.mjs';
import { writeDocuments, writeNavigation } from './documents.mjs';
import { elementScriptIn } from './elementScript.mjs';
import { writeGallery } from './gallery.mjs';
import { writePictures } from './pictures.mjs';
import { publishedAt } from './published.mjs';

/**
 * @param {string} folder of the built site; the documentation goes to `docs` in it
 * @param {(line: string) => void} say
 * @param {boolean} isWhole whether to make what takes long: pictures of parameters and pages of the API. Otherwise they
 * are there if an earlier build made them from the same sources
 */
export async function buildDocs(folder, say, isWhole) {
  const out = join(folder, 'docs');
  rmSync(out, { recursive: true, force: true });
  writeDocuments(folder);
  await writeGallery();
  const hasPictures = await writePictures(isWhole, say);
  const hasApi = await writeApi(isWhole, say);
  writeNavigation([
    { text: 'Presets', link: '/gallery' },
    ...(hasPictures ? [{ text: 'Parameters in pictures', link: '/pictures' }] : []),
    ...(hasApi ? [{ text: 'API', link: '/api/' }] : []),
  ]);
  const base = publishedAt();
  const environment = {
    DOCS_OUT: out,
    DOCS_ELEMENT: `/../${elementScriptIn(folder)}`,
    DOCS_ADDRESS: base ? `${base}docs/` : '',
  };
  const options = { environment, folder: inRoot('site'), onLine: say };
  const { status, output } = await runScript('site/node_modules/vitepress/bin/vitepress.js', ['build'], options);
  if (status !== 0) throw new UserError(`The documentation could not be built:\n${output}`);
  writeScriptLicenses(out, 'site');
  for (const name of filesIn(out, '.map')) rmSync(join(out, name));
  // What a page without a network needs. Pages of the API are many, so they have no HTML of their own there.
  const texts = filesIn(out, '').filter((name) => /\.(html|js|css)$/.test(name) && !/^api\b|\bapi_.*\.lean/.test(name));
  writeFileSync(join(out, 'files.json'), JSON.stringify(texts.map((name) => name.replaceAll('\\', '/'))));
  const broken = brokenLinks(out);
  if (broken.length > 0) throw new UserError(`The documentation has broken links:\n${broken.join('\n')}`);
}

/**
 * Links of the pages to files and headings that do not exist. VitePress looks only at links to its own pages, without
 * their headings.
 *
 * @param {string} folder with HTML files
 * @returns {string[]} lines for a person
 */
export function brokenLinks(folder) {
  return filesIn(folder, '.html').flatMap((name) => {
    const page = join(folder, name);
    const targets = [...readFileSync(page, 'utf8').matchAll(/\s(?:href|src)="([^"]*)"/g)].map(([, target]) => target);
    const broken = targets.filter((target) => !/^[a-z]+:/.test(target) && !leadsSomewhere(target, page));
    return [...new Set(broken)].map((target) => `${name}: ${target}`);
  });
}

/** @param {string} folder @param {string} ending of their names @returns {string[]} relative to the folder */
function filesIn(folder, ending) {
  return readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith(ending));
}

/** @param {string} target @param {string} page absolute path of the file with the link */
function leadsSomewhere(target, page) {
  const [path, heading] = target.replaceAll('&amp;', '&').split('#', 2);
  const [file] = path.split('?');
  const cited =
    file === '' ? page : join(dirname(page), decodeURIComponent(file), file.endsWith('/') ? 'index.html' : '');
  if (!existsSync(cited)) return false;
  // The hash of a share link is no heading.
  if (!heading || heading.includes('=') || !cited.endsWith('.html')) return true;
  return readFileSync(cited, 'utf8').includes(` id="${decodeURIComponent(heading)}"`);
}
