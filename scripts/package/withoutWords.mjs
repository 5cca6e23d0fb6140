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

/** The name and the sentence of a preset, one field in one or two lines. */
const WORDS = /^ {4}(?:label|text):\s+(?:'[^']*'|"[^"]*"),$/gm;

/**
 * Removes the names and sentences of presets, for scripts that do not export them.
 * @returns {import('rolldown').Plugin}
 */
export function withoutPresetWords() {
  return {
    name: 'without-preset-words',
    transform: {
      filter: { id: /src\/preset\/byScene\/(?!fetch|preset)\w+\.ts$/ },
      handler(code) {
        const found = code.match(WORDS)?.length;
        if (found !== 2 * (code.match(/^ {4}name: /gm)?.length ?? 0)) throw new Error('A preset has other words.');
        return { code: code.replace(WORDS, ''), map: null };
      },
    },
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
