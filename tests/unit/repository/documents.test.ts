/**
 * The documents: generated tables, the length of README.md, relative links, files that they name, and the markup of
 * elements. `npm test -- documents` compiles their code.
 */
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { attributes, cssParts, cssProperties, events, slots } from '../../../src/page/element/documentation.ts';
import { names } from '../../../src/page/element/attributes/names.ts';
import { table } from '../../../src/parameters/words/table.ts';
import type { Parameter } from '../../../src/parameters/words/words.ts';
import type { Figure } from '../../bench/support/figures.ts';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const MAX_README_LINES = 150;
const FOLDER = 'docs';
const DOCUMENTS = [
  'README.md',
  'ARCHITECTURE.md',
  'CONTRIBUTING.md',
  'SECURITY.md',
  'scripts/package/README.md',
  ...readdirSync(join(ROOT, FOLDER), { recursive: true, encoding: 'utf8' })
    .filter((file) => file.endsWith('.md'))
    .map((file) => join(FOLDER, file))
    .sort(),
];

function range(parameter: Parameter): string {
  switch (parameter.kind) {
    case 'toggle':
      return '0, 1';
    case 'color':
      return 'colour';
    case 'curve':
      return 'curve';
    case 'path':
    case 'ramp':
    case 'drawing':
    case 'outline':
    case 'timeline':
      return parameter.kind;
    case 'choice':
      return parameter.options.map(({ value }) => value).join(', ');
    default:
      return `${parameter.min} to ${parameter.max} ${parameter.unit}`.trim();
  }
}

/** Where, when and on which rigid an item acts: all forces have these keys, and emitters all but the region. */
const SCOPE = /^\w+\.0\.(region\.|envelope\.|rigid$)/;

/** One row represents all items of a list, all components of a vector, and all keys common to lists. */
function rows(): string[] {
  const listed = table.filter(({ key }) => !/^\w+\.[1-7]\./.test(key) && !/^\w+\.0\..*\.[yz]$/.test(key));
  const scope = listed.filter(({ key }) => SCOPE.test(key) && key.startsWith('winds.'));
  return [
    ...listed.filter(({ key }) => !SCOPE.test(key)).map((parameter) => row(parameter, parameter.key)),
    ...scope.map((parameter) => row(parameter, parameter.key.replace('winds.', '*.'))),
  ];
}

function row(parameter: Parameter, key: string): string {
  const name = key.replace('.0.', '.0‥7.').replace(/(?<=\.0‥7\..*)\.x$/, '.x, .y, .z');
  return `| \`${name}\` | ${range(parameter)} | ${parameter.default} | ${parameter.text} |`;
}

/** The element's API besides the parameters. */
function elementRows(): string[] {
  const kinds = [
    ['attribute', attributes],
    ['event', events],
    ['slot', slots],
    ['part', cssParts],
    ['CSS property', cssProperties],
  ] as const;
  return kinds.flatMap(([kind, list]) =>
    list.map((each) => {
      const initial = 'default' in each && each.default ? ` (${each.default})` : '';
      return `| ${kind} | ${each.name ? `\`${each.name}\`` : 'without a name'} | ${each.description}${initial} |`;
    }),
  );
}

/** What `npm run bench -- costs --json tests/bench/costs.json` recorded. */
function costRows(): string[] {
  const { suite, figures } = JSON.parse(read('tests/bench/costs.json')) as { suite: string; figures: Figure[] };
  expect(suite).toBe('costs');
  const ratio = (value: number) => (value < 10 ? value.toFixed(2) : value.toFixed(1));
  return figures
    .filter(({ unit }) => unit === 'x')
    .map(({ name, value, range: [low, high] }) => {
      return `| ${name.replace(/^costs\./, '')} | ${ratio(value)} | ${ratio(low)} to ${ratio(high)} |`;
    });
}

const TABLES = [
  {
    name: 'costs',
    file: 'docs/performance.md',
    lines: ['| case | ratio | of the rounds |', '| --- | --- | --- |', ...costRows()],
  },
  {
    name: 'parameters',
    file: 'docs/parameters.md',
    lines: ['| key | range | default | description |', '| --- | --- | --- | --- |', ...rows()],
  },
  {
    name: 'element',
    file: 'docs/element.md',
    lines: ['| kind | name | description |', '| --- | --- | --- |', ...elementRows()],
  },
];

it.each(TABLES)('$file has the generated table of the $name (npm run generate writes it)', ({ name, file, lines }) => {
  const text = read(file);
  const block = new RegExp(`(<!-- ${name} -->\n)[^]*(<!-- /${name} -->)`);
  const updated = text.replace(
    block,
    (_, before: string, after: string) => `${before}\n${lines.join('\n')}\n\n${after}`,
  );
  expect(text).toMatch(block);
  if (process.env.GENERATE) writeFileSync(join(ROOT, file), updated);
  else expect(text).toBe(updated);
});

it(`keeps README.md at ${MAX_README_LINES} lines or fewer`, () => {
  expect(read('README.md').trimEnd().split('\n').length).toBeLessThanOrEqual(MAX_README_LINES);
});

it.each(DOCUMENTS)('%s links to files and headings that exist', (file) => {
  expect(linksIn(read(file)).filter((link) => isBroken(link, file))).toEqual([]);
});

it.each([
  ['a missing file', 'missing.md'],
  ['a missing heading', 'docs/glossary.md#missing-heading'],
  ['a missing heading of the same file', '#missing-heading'],
])('finds a link to %s', (_, link) => {
  expect(linksIn(`See [this](${link}).`).filter((each) => isBroken(each, 'README.md'))).toEqual([link]);
});

it('lists every document of the folder in its README', () => {
  const listed = linksIn(read('docs/README.md'));
  const missing = readdirSync(join(ROOT, FOLDER))
    .filter((file) => file.endsWith('.md') && file !== 'README.md')
    .filter((file) => !listed.includes(file));
  expect(missing).toEqual([]);
});

const OF_ALL_ELEMENTS = ['class', 'id', 'slot', 'style', 'title'];

it('writes only attributes that exist into elements', () => {
  const known = [...attributes.map(({ name }) => name), ...names.map(({ attribute }) => attribute), ...OF_ALL_ELEMENTS];
  const tags = DOCUMENTS.flatMap((file) => elementsIn(read(file)));
  expect(tags.length).toBeGreaterThan(2);
  expect(tags.flatMap(attributesIn).filter((name) => !known.includes(name))).toEqual([]);
  const wrong = '```html\n<cartoon-smoke preset="a b" emission-rates="3" paused></cartoon-smoke>\n```';
  expect(elementsIn(wrong).flatMap(attributesIn)).toEqual(['preset', 'emission-rates', 'paused']);
});

/** Files that a build writes. */
const BUILT = [
  'custom-elements.json',
  'html-custom-data.json',
  'web-types.json',
  'gallery/wisp.html',
  'oembed/wisp.json',
];

it('names no source file that does not exist', () => {
  const files = [
    'src',
    'shaders',
    'scripts',
    'tests',
    'public',
    'examples',
    'docs',
    'site/.vitepress',
    '.github',
  ].flatMap((folder) =>
    readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' }).map((path) => `${folder}/${path}`),
  );
  const crates = ['sim', 'world', 'bindings', 'xtask', 'reference', 'fuzz'].flatMap((crate) =>
    readdirSync(join(ROOT, 'sim-wasm', crate), { recursive: true, encoding: 'utf8' }).map((path) => `${crate}/${path}`),
  );
  const ofSite = readdirSync(join(ROOT, 'site')).map((path) => `site/${path}`);
  const paths = [...readdirSync(ROOT), ...ofSite, ...readdirSync(join(ROOT, 'sim-wasm')), ...files, ...crates];
  const known = paths.map((path) => `/${path.replaceAll('\\', '/')}`);
  const cited = DOCUMENTS.flatMap((file) =>
    [...read(file).matchAll(/`([\w./-]+\.(?:ts|mjs|rs|glsl|frag|vert|json|html|css))`/g)].map(([, path]) => ({
      file,
      path,
    })),
  );
  expect(cited.length).toBeGreaterThan(100);
  const missing = cited.filter(
    ({ path }) => !BUILT.includes(path) && !known.some((each) => each.endsWith(`/${path.replace('sim-wasm/', '')}`)),
  );
  expect(missing).toEqual([]);
});

function read(file: string): string {
  return readFileSync(join(ROOT, file), 'utf8');
}

/** The start tags of smoke in HTML blocks. */
function elementsIn(text: string): string[] {
  const blocks = [...text.matchAll(/^```html\b.*\n([^]*?)^```/gm)].map(([, code]) => code);
  return blocks.flatMap((code) => code.match(/<cartoon-smoke\b(?:"[^"]*"|[^">])*>/g) ?? []);
}

function attributesIn(tag: string): string[] {
  return [...tag.replace(/"[^"]*"/g, '').matchAll(/\s([a-z][\w-]*)/g)].map(([, name]) => name);
}

function withoutCode(text: string): string {
  return text.replace(/^```[^]*?^```/gm, '');
}

/** Relative targets of links and images, without those in code. */
function linksIn(text: string): string[] {
  const prose = withoutCode(text).replace(/`[^`\n]*`/g, '');
  const targets = [...prose.matchAll(/\]\(([^()\s]+)\)|^\[[^\]]+\]: (\S+)/gm)].map(
    ([, inline, named]) => inline ?? named,
  );
  return targets.filter((target) => !/^[a-z]+:/.test(target));
}

/** @param from the file with the link */
function isBroken(link: string, from: string): boolean {
  const [path, heading] = link.split('#', 2);
  const file = path === '' ? from : join(dirname(from), path);
  if (!existsSync(join(ROOT, file))) return true;
  return heading !== undefined && !headingsOf(read(file)).includes(heading);
}

/** Anchors of the headings, in GitHub's format. */
function headingsOf(text: string): string[] {
  const headings = [...withoutCode(text).matchAll(/^#{1,6} (.+)$/gm)];
  return headings.map(([, heading]) =>
    heading
      .toLowerCase()
      .replace(/[^\p{L}\p{N} _-]/gu, '')
      .trim()
      .replaceAll(' ', '-'),
  );
}
