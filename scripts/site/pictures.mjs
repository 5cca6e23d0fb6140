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

const CACHE = '.cache/docs/pictures';
const MODULE = 'tests/visual/demo/parameterPictures.cases.ts';
const SOURCES = [MODULE, 'shaders', 'src/parameters', 'src/renderer', 'src/scenes', 'src/simulator'];
const SIZE = { width: 192, height: 128 };

/** Groups that a still picture can show. */
const GROUPS = ['emission', 'style', 'light', 'puff', 'forces', 'turbulence', 'air'];
/** What others show, or what only a film shows. */
const LEFT_OUT = /^(style\.(renderer|volumes|hold|wash|washColor)|puff\.(precision|seed|views)|light\.decay)$/;

/** Shares of the slider for the low and the high value. */
const LOW = 0.1;
const HIGH = 0.8;

/**
 * Other values without which a parameter has no effect.
 * @type {readonly (readonly [keys: RegExp, values: Record<string, number | string>])[]}
 */
const NEEDED = [
  [/^style\.(shadowDepth|deepShadow)$/, { 'style.shadowSteps': 2 }],
  [/^style\.gradient(Color|Bottom|Top)$/, { 'style.gradient': 'height' }],
  [/^style\.pattern[A-Z]/, { 'style.pattern': 'lines', 'style.patternOn': 'both' }],
  [/^style\.rimColor$/, { 'style.rim': 0.6 }],
  [/^style\.rampBlend$/, { 'style.ramp': '0:3b2a6b,.4:d9577a,1:fff0c2' }],
  [/^style\.inkLight$/, { 'light.color': '#ff9a50', 'light.intensity': 2 }],
  [/^light\.distance$/, { 'light.kind': 'lamp' }],
  [/^wind\./, { 'forces.wind.x': 0.6 }],
];

/**
 * Low and high values where those of the slider are more than a picture shows.
 * @type {Readonly<Record<string, readonly [low: number, high: number]>>}
 */
const ENDS = {
  'emission.rate': [8, 120],
  'emission.lifetime': [2, 13],
  'puff.size': [0.4, 2],
  'forces.wind.x': [-1.2, 1.2],
  'forces.wind.y': [-1.2, 1.2],
  'forces.wind.z': [-1.2, 1.2],
  'turbulence.speed': [0, 0.6],
  'buoyancy.acceleration': [0.3, 5],
  'buoyancy.coolingTime': [0.5, 20],
  'drag.rate': [0.4, 10],
  'drag.quadratic': [0, 20],
  'wind.gusts': [0, 1],
  'wind.shear': [-0.5, 0.5],
};

/** Colours that differ from every default. */
const COLORS = ['#2f6fde', '#d9573a'];

/** @typedef {import('../../src/parameters/words/words.ts').Parameter} Parameter */
/** @typedef {{ key: string, label: string, values: Record<string, number | string> }} Picture */

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
need another have it in all of their pictures. [Parameters](parameters.md) lists all, with their ranges.`;

async function parameters() {
  /** @type {{ table: Parameter[], groups: { key: string, label: string }[] }} */
  const { table, groups } = await sourceModule('src/parameters/words/table.ts');
  const shown = table.filter(
    ({ key, group, kind }) =>
      GROUPS.includes(group) &&
      !/\.\d\./.test(key) &&
      !LEFT_OUT.test(key) &&
      ['number', 'integer', 'toggle', 'choice', 'color'].includes(kind),
  );
  return { shown, groups };
}

/** @returns {Picture[]} */
function picturesOf(/** @type {Parameter} */ parameter) {
  const { key } = parameter;
  const needed = Object.assign({}, ...NEEDED.filter(([keys]) => keys.test(key)).map(([, values]) => values));
  return valuesOf(parameter).map(([label, value]) => ({ key, label, values: { ...needed, [key]: value } }));
}

/** @returns {[label: string, value: number | string][]} */
function valuesOf(/** @type {Parameter} */ parameter) {
  const { key } = parameter;
  switch (parameter.kind) {
    case 'number':
    case 'integer': {
      const { min, max, unit, default: initial } = parameter;
      const reach = (/** @type {number} */ share) => at(parameter, share);
      const [low, high] = ENDS[key] ?? [
        reach(LOW) < initial ? reach(LOW) : min,
        reach(HIGH) > initial ? reach(HIGH) : max,
      ];
      const values = [...new Set([low, initial, high])];
      return values.map((value) => [
        `${value} ${unit}${value === initial ? ', default' : ''}`.replace(' ,', ','),
        value,
      ]);
    }
    case 'toggle':
      return [0, 1].map((value) => [`${value ? 'on' : 'off'}${value === parameter.default ? ', default' : ''}`, value]);
    case 'choice':
      return parameter.options.map(({ value, label }) => [
        `${label}${value === parameter.default ? ', default' : ''}`,
        value,
      ]);
    case 'color':
      return [parameter.default, ...COLORS].map((value, index) => [`${value}${index === 0 ? ', default' : ''}`, value]);
    default:
      return [];
  }
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
