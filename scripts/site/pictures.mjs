/**
 * Pictures of the parameters: a low, the default and a high value of each that changes what one sees. They are kept
 * under hashes of everything that they depend on, so a picture on the site is never of another version.
 */

import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { inRoot } from '../lib/paths.mjs';
import { sourceModule } from '../package/sourceModule.mjs';
import { findBrowser } from '../setup/browser.mjs';
import { digestOf } from '../setup/sources.mjs';
import { PAGES, write } from './documents.mjs';
import { GROUPS, ITEMS, LEFT_OUT, NEEDED, VALUES } from './pictureValues.mjs';

const CACHE = '.cache/docs/pictures';
const MODULE = 'tests/visual/demo/parameterPictures.cases.ts';
const SOURCES = [MODULE, 'shaders', 'src/parameters', 'src/renderer', 'src/scenes', 'src/simulator'];
const SIZE = { width: 192, height: 128 };

/** Shares of the slider for the low and the high value. */
const LOW = 0.1;
const HIGH = 0.8;

/** Colours that differ from every default. */
const COLORS = ['#2f6fde', '#d9573a'];

/** @typedef {import('../../src/parameters/words/words.ts').Parameter} Parameter */
/** @typedef {{ key: string, label: string, values: Record<string, number | string> }} Picture the label is HTML */

/**
 * Writes the page of the pictures, and draws those that are missing.
 *
 * @param {boolean} draws whether to draw; otherwise there is only a page if they exist
 * @param {(line: string) => void} say
 * @returns {Promise<boolean>} whether there is a page
 */
export async function writePictures(draws, say) {
  const { shown, groups } = await parameters();
  const pictures = shown.flatMap(picturesOf);
  const folder = inRoot(`${CACHE}/${digestOf(SOURCES).slice(0, 16)}`);
  const missing = pictures.filter((picture) => !existsSync(`${folder}/${fileOf(picture)}`));
  if (missing.length > 0) {
    if (!draws) return false;
    if (!(await findBrowser())) {
      say('There is no Chromium, so the documentation has no pictures of parameters.');
      return false;
    }
    await draw(missing, folder, say);
  }
  mkdirSync(inRoot(`${PAGES}/parameters`), { recursive: true });
  const sections = groups.map(({ key, label }) => {
    const entries = shown
      .filter(({ group }) => group === key)
      .flatMap((parameter) => entry(parameter, pictures, folder));
    return entries.length > 0 ? [`## ${label}`, ...entries] : [];
  });
  write('pictures.md', `${[INTRODUCTION, ...sections.flat()].join('\n\n')}\n`);
  return true;
}

const INTRODUCTION = `---
outline: 2
---

# Parameters in pictures

The lamp after four seconds, with one parameter changed: a low value, the default and a high one, or each choice. Parameters that
need another have it in all of their pictures. Those of lists are shown for one item, such as the first vortex; regions and
envelopes of all forces work as those of the wind. [Parameters](parameters.md) lists all, with their ranges.`;

async function parameters() {
  /** @type {{ table: Parameter[], groups: { key: string, label: string }[] }} */
  const { table, groups } = await sourceModule('src/parameters/words/table.ts');
  const { itemGroups } = await sourceModule('src/parameters/words/lists.ts');
  const shown = table.filter(({ key, group, kind }) => {
    const inList = fieldIn(key);
    if (inList) return inList.values !== undefined;
    const hasValues = key in VALUES || ['number', 'integer', 'toggle', 'choice', 'color'].includes(kind);
    return GROUPS.includes(group) && !LEFT_OUT.test(key) && hasValues;
  });
  const keys = new Set(table.map(({ key }) => key));
  const named = [...Object.keys(VALUES), ...Object.entries(ITEMS).flatMap(keysOfItem)];
  const unknown = named.filter((key) => !keys.has(key));
  if (unknown.length > 0)
    throw new Error(`There are values for pictures of ${unknown.join(', ')}, but no such parameters.`);
  const outdated = shown.filter((parameter) => !valuesOf(parameter).includes(parameter.default));
  if (outdated.length > 0)
    throw new Error(
      `Pictures of ${outdated.map(({ key }) => key).join(', ')} lack the default: see pictureValues.mjs.`,
    );
  return { shown, groups: [...groups, ...itemGroups] };
}

/** @param {[list: string, pictured: (typeof ITEMS)[string]]} entry @returns {string[]} keys of parameters */
function keysOfItem([list, { item, fields }]) {
  return [...Object.keys(item), ...Object.keys(fields)].map((field) => `${list}.0.${field}`);
}

/** The first item of a list in a key, and the values of the field; nothing for another key. */
function fieldIn(/** @type {string} */ key) {
  const [, list, index, field] = /^(\w+)\.(\d+)\.(.+)$/.exec(key) ?? [];
  if (list === undefined) return undefined;
  const pictured = Object.entries(ITEMS).find(([name]) => name === list)?.[1];
  return { list, item: pictured?.item ?? {}, values: index === '0' ? pictured?.fields[field] : undefined };
}

/** @returns {Picture[]} */
function picturesOf(/** @type {Parameter} */ parameter) {
  const { key } = parameter;
  const { list, item = {} } = fieldIn(key) ?? {};
  const ofItem = Object.entries(item).map(([field, value]) => [`${list}.0.${field}`, value]);
  const needed = NEEDED.filter(([keys]) => keys.test(key)).map(([, values]) => values);
  const others = Object.assign(Object.fromEntries(ofItem), ...needed);
  return valuesOf(parameter).map((value) => ({
    key,
    label: labelOf(parameter, value),
    values: { ...others, [key]: value },
  }));
}

/** @returns {readonly (number | string)[]} */
function valuesOf(/** @type {Parameter} */ parameter) {
  const given = VALUES[parameter.key] ?? fieldIn(parameter.key)?.values;
  if (given && given.length > 0) return given;
  switch (parameter.kind) {
    case 'number':
    case 'integer': {
      const { min, max, default: initial } = parameter;
      const [low, high] = [at(parameter, LOW), at(parameter, HIGH)];
      return [...new Set([low < initial ? low : min, initial, high > initial ? high : max])];
    }
    case 'toggle':
      return [0, 1];
    case 'choice':
      return parameter.options.map(({ value }) => value);
    case 'color':
      return [parameter.default, ...COLORS];
    default:
      return [];
  }
}

/** @returns {string} as HTML */
function labelOf(/** @type {Parameter} */ parameter, /** @type {number | string} */ value) {
  const named = nameOf(parameter, value);
  return value === parameter.default ? `${named}, default` : named;
}

/** @returns {string} as HTML */
function nameOf(/** @type {Parameter} */ parameter, /** @type {number | string} */ value) {
  if (parameter.kind === 'toggle') return value ? 'on' : 'off';
  if (parameter.kind === 'choice')
    return parameter.options.find((option) => option.value === value)?.label ?? `${value}`;
  if (parameter.kind === 'color') return `${value}`;
  if (typeof value === 'string') return value === '' ? 'none' : `<code>${value.replaceAll(',', ',<wbr>')}</code>`;
  return 'unit' in parameter ? `${value} ${parameter.unit}`.trim() : `${value}`;
}

/** The value at a share of the slider, rounded to the steps of the panel. @returns {number} */
function at(
  /** @type {Extract<Parameter, { min: number }>} */ { min, max, step, slider },
  /** @type {number} */ share,
) {
  // A fine slider would end far beyond what a page draws.
  const value = min + (max - min) * (slider === 'fine' ? (share * 0.75) ** 3 : share);
  return Number((Math.round(value / step) * step).toPrecision(6));
}

/** @param {Picture[]} pictures @param {string} folder @param {(line: string) => void} say */
async function draw(pictures, folder, say) {
  const { evaluateInPage } = await import('../../tests/bench/support/page.mjs');
  // Pictures of other versions.
  if (!existsSync(folder)) rmSync(inRoot(CACHE), { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const expression = `import('/${MODULE}').then(({ draw }) => draw(${JSON.stringify(pictures)}, sayProgress))`;
  const drawn = /** @type {string[]} */ (await evaluateInPage(expression, (line) => say(`picture ${line}`)));
  for (const [index, text] of drawn.entries()) {
    writeFileSync(`${folder}/${fileOf(pictures[index])}`, Buffer.from(text, 'base64'));
  }
}

/** @returns {string} name of a file with these values */
function fileOf(/** @type {Picture} */ { values }) {
  return `${createHash('sha256').update(JSON.stringify(values)).digest('hex').slice(0, 16)}.webp`;
}

/**
 * The pictures of a parameter; none if they are all the same.
 *
 * @param {Parameter} parameter
 * @param {Picture[]} pictures
 * @param {string} folder
 * @returns {string[]}
 */
function entry({ key, label, text }, pictures, folder) {
  const own = pictures
    .filter((picture) => picture.key === key)
    .map((picture) => ({ label: picture.label, file: fileOf(picture) }));
  const contents = own.map(({ file }) => readFileSync(`${folder}/${file}`));
  if (new Set(contents.map((bytes) => bytes.toString('base64'))).size < 2) return [];
  const figures = own.map(({ label: value, file }, index) => {
    writeFileSync(inRoot(`${PAGES}/parameters/${file}`), contents[index]);
    const size = `width="${SIZE.width}" height="${SIZE.height}"`;
    return `<figure><img src="./parameters/${file}" ${size} alt="" loading="lazy" /><figcaption>${value}</figcaption></figure>`;
  });
  return [
    `### ${label} {#${key.replaceAll('.', '-')}}`,
    `\`${key}\`. ${text}`,
    `<div class="values">${figures.join('')}</div>`,
  ];
}
