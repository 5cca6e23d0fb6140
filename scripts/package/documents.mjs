/** The README and the guides of the package, with links that work in it. */

import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { inRoot } from '../lib/paths.mjs';
import { address, manifest } from './manifest.mjs';

const README = 'scripts/package/README.md';
const GUIDES = 'docs';

/**
 * Writes `README.md` and `docs/`. The design documents are for people who change the project, so the package has links to them.
 * @param {string} folder of the package
 */
export function writeDocuments(folder) {
  const guides = readdirSync(inRoot(GUIDES)).filter((file) => file.endsWith('.md'));
  /** Places in the package by paths in the repository. */
  const places = new Map([[README, 'README.md'], ...guides.map((file) => pair(`${GUIDES}/${file}`))]);
  for (const [source, place] of places) {
    mkdirSync(dirname(join(folder, place)), { recursive: true });
    writeFileSync(join(folder, place), rewritten(readFileSync(inRoot(source), 'utf8'), source, places));
  }
}

/** @returns {[source: string, place: string]} */
function pair(/** @type {string} */ path) {
  return [path, path];
}

/**
 * Links to a document of the package stay relative. Other files are those of this version in the repository.
 *
 * @param {string} text
 * @param {string} source path of the document in the repository
 * @param {Map<string, string>} places
 */
function rewritten(text, source, places) {
  const [from, folder] = [dirname(source), dirname(places.get(source) ?? source)];
  // Code, or a link or an image.
  return text.replace(
    /^```[^]*?^```|`[^`\n]*`(?!\])|(!?)(\[(?:`[^`]*`|[^\]`])*\])\(([^()\s]+)\)/gm,
    (all, image, label, link) => {
      if (!link || /^(#|[a-z]+:)/.test(link)) return all;
      const [target, heading] = link.split('#');
      const path = posix.join(from, target);
      if (!existsSync(inRoot(path))) throw new Error(`${source} links to ${link}, which does not exist.`);
      const place = places.get(path);
      const shown = place
        ? posix.relative(folder, place)
        : `${address}/${image ? 'raw' : 'blob'}/v${manifest.version}/${path}`;
      return `${image}${label}(${heading ? `${shown}#${heading}` : shown})`;
    },
  );
}
