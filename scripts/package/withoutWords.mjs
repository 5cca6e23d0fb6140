/**
 * A bundler plugin that removes labels, descriptions and panel-only fields from the parameter table. A widget needs
 * only ranges and defaults. Keys come from the list of attribute names, and the first item of a list represents all.
 */

import { inRoot } from '../lib/paths.mjs';
import { names, OF_LATER_ITEMS, table } from './parameters.mjs';

/** The fields of a row that smoke needs. */
const USED = ['kind', 'reader', 'isOptional', 'unit', 'min', 'max', 'linkMax', 'default'];
/**
 * Default fields, which rows may omit.
 * @type {Record<string, unknown>}
 */
const USUAL = { kind: 'number', reader: 'simulator' };

/** @returns {import('rolldown').Plugin} */
export function withoutWords() {
  return {
    name: 'without-words',
    load: (id) => (id === inRoot('src/preset/table.ts') ? { code: tableModule(), moduleType: 'js' } : undefined),
  };
}

/** The source of the reduced table module. */
function tableModule() {
  const stray = table.find(({ key }, index) => key !== names[index].key);
  if (stray) throw new Error(`${stray.key} has another position in src/element/attributes/names.json.`);
  const rows = table.filter(({ key }) => !OF_LATER_ITEMS.test(key)).map(bare);
  return `
    import { names } from '../element/attributes/names.ts';
    const bare = ${JSON.stringify(rows)};
    const first = names.filter(({ key }) => !${OF_LATER_ITEMS}.test(key));
    const usual = ${JSON.stringify(USUAL)};
    const bareByKey = new Map(first.map(({ key }, index) => [key, { ...usual, ...bare[index] }]));
    export const table = names.map(({ key }) => ({ ...bareByKey.get(key.replace(/(?<=^\\w+\\.)\\d(?=\\.)/, 0)), key }));
    const rows = new Map(table.map((row) => [row.key, row]));
    export const findParameter = (key) => rows.get(key);`;
}

/** @param {object} row */
function bare(row) {
  const used = Object.entries(row).filter(([name, value]) => USED.includes(name) && value !== USUAL[name]);
  const options = 'options' in row ? { options: valuesOf(/** @type {{ value: unknown }[]} */ (row.options)) } : {};
  return { ...Object.fromEntries(used), ...options };
}

/** @param {{ value: unknown }[]} options */
function valuesOf(options) {
  return options.map(({ value }) => ({ value }));
}
