import { readFileSync } from 'node:fs';
import { inRoot } from '../lib/paths.mjs';

const STYLES = inRoot('src/element/shell/appearance.ts');
/** White space that says nothing: beside braces and semicolons, behind the colon of a property, and runs of it. */
const IDLE = /\s*([{};])\s*|(?<=:) |(?<=,)\s+/g;

/** A plugin for the bundler: the element's styles without white space. @returns {import('rolldown').Plugin} */
export function shortStyles() {
  return {
    name: 'short-styles',
    load: (id) => (id === STYLES ? { code: shortened(readFileSync(id, 'utf8')), moduleType: 'ts' } : undefined),
  };
}

/** @param {string} module whose only template is a style sheet */
function shortened(module) {
  return module.replace(/`[^`]*`/, (styles) => styles.replace(IDLE, '$1').replace(/;}/g, '}'));
}
