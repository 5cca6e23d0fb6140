/**
 * A plugin for the bundler: the parameter table without its labels and texts, and without what only a panel needs. A
 * widget knows ranges and defaults; nobody reads words there.
 */

import { readFileSync } from 'node:fs';
import { inRoot } from '../lib/paths.mjs';

/** What smoke needs of a row. */
const KEPT = ['kind', 'key', 'reader', 'isOptional', 'unit', 'min', 'max', 'linkMax', 'default'];
/** What smoke does not need of a list. */
const LEFT_OUT = ['label', 'text', 'start'];

/**
 * @param {readonly import('../../src/preset/parameter.ts').Parameter[]} table as it is
 * @returns {import('rolldown').Plugin}
 */
export function withoutWords(table) {
  return {
    name: 'without-words',
    load(id) {
      if (id === inRoot('src/preset/table.ts')) return { code: tableModule(table), moduleType: 'js' };
      if (id === inRoot('src/preset/lists.json')) return { code: listsWithoutWords(), moduleType: 'json' };
      return undefined;
    },
  };
}

/** The module of the table as it would be if rows had no words. @param {readonly { key: string }[]} table */
function tableModule(table) {
  const single = table.filter(({ key }) => !/^\w+\.\d\./.test(key)).map(bare);
  return `
    import { listParameters } from './lists.ts';
    export const table = [...${JSON.stringify(single)}, ...listParameters()];
    const rows = new Map(table.map((row) => [row.key, row]));
    export const findParameter = (key) => rows.get(key);`;
}

/** @param {object} row */
function bare(row) {
  const kept = Object.entries(row).filter(([name]) => KEPT.includes(name));
  const options = 'options' in row ? { options: valuesOf(/** @type {{ value: unknown }[]} */ (row.options)) } : {};
  return { ...Object.fromEntries(kept), ...options };
}

/** @param {{ value: unknown }[]} options */
function valuesOf(options) {
  return options.map(({ value }) => ({ value }));
}

function listsWithoutWords() {
  const text = readFileSync(inRoot('src/preset/lists.json'), 'utf8');
  return JSON.stringify(JSON.parse(text, (name, value) => (LEFT_OUT.includes(name) ? undefined : value)));
}
