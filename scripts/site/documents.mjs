/**
 * The pages of the documentation site: the Markdown of the repository, with links that work on the site. The files in
 * docs/ remain plain Markdown, which GitHub shows as it is.
 */

import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { inRoot } from '../lib/paths.mjs';

/** The folder that VitePress reads. Inside of site/, because pages import packages of it. */
export const PAGES = 'site/pages';

const FOLDER = 'docs';
const INDEX = 'docs/README.md';
const DESIGN = 'docs/design';
const POSTERS = 'src/demo/posters';
const WIDE = '.wide.webp';

/** The group of the pages that the build makes. */
const GROUP_OF_MADE = 'Look it up';

/** Documents outside of docs/ that are pages, too. */
const OTHERS = ['ARCHITECTURE.md', 'CHANGELOG.md', 'CONTRIBUTING.md', 'SECURITY.md'];

/** Code is matched to leave it as it is. */
const CODE_OR_LINK = /^```[^]*?^```|`[^`\n]*`|(!?)\[((?:`[^`]*`|[^[\]`])*)\]\(([^()\s]+)\)/gm;

/**
 * @typedef {{ text: string, link: string }} Entry
 * @typedef {{ text: string, collapsed?: boolean, items: Entry[] }} Group
 */

/**
 * Writes all pages.
 *
 * @param {string} site folder of the built site, whose pages the documents link to
 */
export function writeDocuments(site) {
  rmSync(inRoot(PAGES), { recursive: true, force: true });
  const pages = pagesByDocument();
  for (const [file, page] of pages) {
    write(page, withFigures(withLinks(readFileSync(inRoot(file), 'utf8'), file, pages, site)));
  }
  cpSync(inRoot(`${FOLDER}/images`), inRoot(`${PAGES}/images`), { recursive: true });
  for (const file of readdirSync(inRoot(POSTERS)).filter((name) => name.endsWith(WIDE))) {
    cpSync(inRoot(`${POSTERS}/${file}`), inRoot(`${PAGES}/posters/${file.replace(WIDE, '.webp')}`));
  }
}

/**
 * Writes `navigation.json` beside the pages.
 *
 * @param {Entry[]} made pages that are no documents
 */
export function writeNavigation(made) {
  write('navigation.json', JSON.stringify(navigation(pagesByDocument(), made)));
}

function pagesByDocument() {
  const documents = [...OTHERS, ...markdownIn(FOLDER), ...markdownIn(DESIGN)];
  return new Map(documents.map((file) => [file, pageOf(file)]));
}

/**
 * @param {string} page relative to the folder of the pages
 * @param {string} text
 */
export function write(page, text) {
  const path = join(inRoot(PAGES), page);
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, text);
}

/** @returns {string[]} paths in the repository */
function markdownIn(/** @type {string} */ folder) {
  return readdirSync(inRoot(folder))
    .filter((name) => name.endsWith('.md'))
    .map((name) => `${folder}/${name}`);
}

/** @returns {string} relative to the folder of the pages */
function pageOf(/** @type {string} */ file) {
  if (file === INDEX) return 'index.md';
  return file.startsWith(`${FOLDER}/`) ? file.slice(FOLDER.length + 1) : file.toLowerCase();
}

/**
 * Links to documents become links to their pages, links to pages of the site leave the documentation, and links to other
 * files open them in the repository.
 *
 * @param {string} text
 * @param {string} file
 * @param {Map<string, string>} pages by document
 * @param {string} site
 */
function withLinks(text, file, pages, site) {
  const here = dirname(pageOf(file));
  return text.replace(CODE_OR_LINK, (whole, picture, label, target) => {
    if (!target || /^[a-z]+:|^#/.test(target)) return whole;
    const [path, ...heading] = target.split(/(?=#)/);
    const cited = posix.join(dirname(file), path);
    const page = pages.get(cited);
    if (page) return `[${label}](${relative(here, page)}${heading.join('')})`;
    if (picture) return whole;
    const inSite = [cited, cited.replace(/^public\//, '')].find((each) => existsSync(join(site, each)));
    if (inSite) return leaving(relative(here, `../${inSite}`), label);
    return `[${label}](${repository()}/blob/main/${cited}${heading.join('')})`;
  });
}

/** Figures of a debug view, and the measurement, in place of their comments, which GitHub does not show. */
function withFigures(/** @type {string} */ text) {
  const poster = (/** @type {string} */ preset) =>
    `<img src="./posters/${preset}.webp" width="800" height="400" alt="" />`;
  return text
    .replace(
      /^<!-- figure: (\w+) ([\w-]+) -->$/gm,
      (_, view, preset) => `<DebugFigure view="${view}" preset="${preset}">${poster(preset)}</DebugFigure>`,
    )
    .replace(/^<!-- measure: ([\w-]+) -->$/gm, (_, preset) => `<MeasureCosts>${poster(preset)}</MeasureCosts>`);
}

/**
 * A link that the router of VitePress leaves to the browser.
 *
 * @param {string} target
 * @param {string} label Markdown
 */
function leaving(target, label) {
  return `<a href="${target}" target="_self">${label.replace(/`([^`]+)`/g, '<code>$1</code>')}</a>`;
}

/** @param {string} folder @param {string} page both relative to the folder of the pages */
function relative(folder, page) {
  const path = posix.relative(folder, page);
  return path.startsWith('.') ? path : `./${path}`;
}

/** @returns {string} the address of the repository */
function repository() {
  const { repository: name } = JSON.parse(readFileSync(inRoot('package.json'), 'utf8'));
  return `https://github.com/${name.replace(/^github:/, '')}`;
}

/**
 * The groups and their pages: the headings and the lists of docs/README.md, then the design documents.
 *
 * @param {Map<string, string>} pages
 * @param {Entry[]} made
 * @returns {{ repository: string, groups: Group[] }}
 */
function navigation(pages, made) {
  const groups = sections(readFileSync(inRoot(INDEX), 'utf8')).map(({ heading, lines }) => ({
    text: heading,
    items: [
      ...lines.flatMap((line) => {
        const [, label, target] = /^- \[([^\]]+)\]\(([^)]+)\)/.exec(line) ?? [];
        return label ? [{ text: plain(label), link: linkTo(pages.get(posix.join(FOLDER, target)) ?? target) }] : [];
      }),
      ...(heading === GROUP_OF_MADE ? made : []),
    ],
  }));
  const items = markdownIn(DESIGN).map((file) => ({ text: titleOf(file), link: linkTo(pageOf(file)) }));
  return { repository: repository(), groups: [...groups, { text: 'Design', collapsed: true, items }] };
}

/** @param {string} text */
function sections(text) {
  return text
    .split(/^## /m)
    .slice(1)
    .map((section) => {
      const [heading, ...lines] = section.split('\n');
      return { heading, lines };
    });
}

function titleOf(/** @type {string} */ file) {
  return plain(/^# (.+)$/m.exec(readFileSync(inRoot(file), 'utf8'))?.[1] ?? file);
}

function plain(/** @type {string} */ markdown) {
  return markdown.replaceAll('`', '').replace(/\\(.)/g, '$1');
}

function linkTo(/** @type {string} */ page) {
  return `/${page.replace(/(index)?\.md$/, '')}`;
}
