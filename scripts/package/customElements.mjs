/**
 * The custom-elements manifest (schema 1.0.0), which editors use to complete tags and attributes. Parameters come from
 * the parameter table; the first item of a list represents all eight.
 */

import { names, OF_LATER_ITEMS, table } from './parameters.mjs';
import { sourceModule } from './sourceModule.mjs';

/**
 * @typedef {import('../../src/preset/parameter.ts').Parameter} Parameter
 * @typedef {{ name: string, type: { text: string }, description: string, default?: string }} Described
 */

/** @type {typeof import('../../src/element/documentation.ts')} */
const { attributes, cssParts, cssProperties, events, methods, slots } =
  await sourceModule('src/element/documentation.ts');

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
      ...all.map(({ fieldName, type, description }) => ({ kind: 'field', name: fieldName, type, description })),
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

function camelCase(/** @type {string} */ name) {
  return name.replace(/-(.)/g, (_, letter) => letter.toUpperCase());
}

/** @param {Parameter} row */
function describe(row) {
  const name = names.find(({ key }) => key === row.key);
  const items = /^\w+\.0\./.test(row.key) ? ' For the first of eight items, 0 to 7.' : '';
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
