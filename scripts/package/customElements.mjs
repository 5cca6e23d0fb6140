/**
 * The custom-elements manifest (schema 1.0.0), which editors use to complete tags and attributes. Parameters come from
 * the parameter table; the first item of a list represents all eight.
 */

import { names, OF_LATER_ITEMS, table } from './parameters.mjs';
import { sourceModule } from './sourceModule.mjs';

/**
 * @typedef {import('../../src/parameters/words/words.ts').Parameter} Parameter
 * @typedef {{ name: string, type: { text: string }, description: string, default?: string }} Described
 */

/** @type {typeof import('../../src/page/element/documentation.ts')} */
const { attributes, cssParts, cssProperties, events, methods, slots } = await sourceModule(
  'src/page/element/documentation.ts',
);

/** The index in names of a list's first item, `emitters-0-speed` and `emitters0Speed`. */
const FIRST_ITEM = /(?<=[a-z])0(?=[A-Z])|(?<=-)0(?=-)/;
const OF_FIRST_ITEM = ' For the first of eight items, 0 to 7.';
const MODULE = 'dist/element.js';
const CLASS = 'CartoonSmokeElement';
const TAG = 'cartoon-smoke';

export function customElements() {
  const parameters = table.filter(({ key }) => !OF_LATER_ITEMS.test(key)).map(describe);
  const all = [...attributes.map((each) => ({ ...each, fieldName: camelCase(each.name) })), ...parameters];
  const declaration = {
    kind: 'class',
    name: CLASS,
    customElement: true,
    tagName: TAG,
    description: 'Cartoon smoke. It loads when it comes near the viewport.',
    superclass: { name: 'HTMLElement', package: 'global:' },
    attributes: all,
    members: [
      // The attributes describe them: their descriptions are a quarter of the file.
      ...all.map(({ name, fieldName, type }) => ({ kind: 'field', name: fieldName, type, attribute: name })),
      ...methods.map((method) => ({ kind: 'method', ...method })),
    ],
    events,
    slots,
    cssParts,
    cssProperties,
  };
  const own = { name: CLASS, module: MODULE };
  const exported = [
    { kind: 'js', name: CLASS, declaration: own },
    { kind: 'custom-element-definition', name: TAG, declaration: own },
  ];
  const modules = [{ kind: 'javascript-module', path: MODULE, declarations: [declaration], exports: exported }];
  return { schemaVersion: '1.0.0', readme: 'README.md', modules };
}

/**
 * Custom data for the HTML editor of VS Code (version 1.1). The format has no patterns, so it leaves out the attributes of
 * list items: they would be most of the suggestions. The editor accepts attributes that are not listed.
 * @param {ReturnType<typeof customElements>} manifest
 */
export function htmlCustomData(manifest) {
  const [{ tagName, description, attributes: all }] = manifest.modules[0].declarations;
  const single = all.filter(({ name }) => !FIRST_ITEM.test(name));
  const described = single.map((each) => {
    const values = choicesOf(each).map((name) => ({ name }));
    return { name: each.name, description: each.description, ...(values.length > 0 && { values }) };
  });
  return { version: 1.1, tags: [{ name: tagName, description, attributes: described }] };
}

/**
 * Web types for the editors of JetBrains. Attributes and properties of list items are patterns, which the editors accept
 * and explain but do not suggest.
 * @param {ReturnType<typeof customElements>} manifest
 * @param {string} version
 */
export function webTypes(manifest, version) {
  const [{ tagName, description, attributes: all, events: own }] = manifest.modules[0].declarations;
  const attributesOf = all.map((each) => {
    const values = choicesOf(each);
    const type = values.length > 0 ? values.map((value) => `'${value}'`).join(' | ') : each.type.text;
    return { ...named(each), default: each.default, value: { type } };
  });
  const properties = all.map(({ fieldName, description: text }) => named({ name: fieldName, description: text }));
  const js = { events: own.map(({ name, description: text }) => ({ name, description: text })), properties };
  const elements = [{ name: tagName, description, attributes: attributesOf, js }];
  return {
    $schema: 'https://json.schemastore.org/web-types',
    name: 'cartoon-smoke',
    version,
    'description-markup': 'markdown',
    contributions: { html: { elements } },
  };
}

/** Name and description in web types, with the pattern of all items. @param {{ name: string, description: string }} of */
function named({ name, description }) {
  if (!FIRST_ITEM.test(name)) return { name, description };
  const all = description.replace(OF_FIRST_ITEM, '').replace('.0.', '.#.');
  return { name: name.replace(FIRST_ITEM, '#'), pattern: name.replace(FIRST_ITEM, '[0-7]'), description: all };
}

/** The values of a choice. @param {{ type: { text: string } }} of */
function choicesOf({ type }) {
  return [...type.text.matchAll(/'([^']*)'/g)].map(([, value]) => value);
}

function camelCase(/** @type {string} */ name) {
  return name.replace(/-(.)/g, (_, letter) => letter.toUpperCase());
}

/** @param {Parameter} row */
function describe(row) {
  const name = names.find(({ key }) => key === row.key);
  const items = /^\w+\.0\./.test(row.key) ? OF_FIRST_ITEM : '';
  return {
    name: name?.attribute ?? row.key,
    fieldName: name?.property ?? row.key,
    type: { text: typeOf(row) },
    default: String(row.default),
    description: `${row.label}: ${row.text}${items} (${row.key})`,
  };
}

/**
 * The TypeScript type of a parameter.
 * @param {Parameter} row
 */
export function typeOf(row) {
  if (row.kind === 'choice')
    return row.options.map(({ value }) => JSON.stringify(value).replaceAll('"', "'")).join(' | ');
  if (row.kind === 'toggle') return '0 | 1';
  return row.kind === 'number' || row.kind === 'integer' ? 'number' : 'string';
}
