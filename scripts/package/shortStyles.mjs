import { readFileSync } from 'node:fs';
import { inRoot } from '../lib/paths.mjs';

const STYLES = inRoot('src/element/shell/appearance.ts');
/** Insignificant white space: beside braces and semicolons, after a property's colon, and runs of it. */
const IDLE = /\s*([{};])\s*|(?<=:) |(?<=,)\s+/g;

/**
 * A bundler plugin that removes white space from the element's styles.
 * @returns {import('rolldown').Plugin}
 */
export function shortStyles() {
  return {
    name: 'short-styles',
    load: (id) => (id === STYLES ? { code: shortened(readFileSync(id, 'utf8')), moduleType: 'ts' } : undefined),
  };
}

/** @param {string} module whose only template literal is a style sheet */
function shortened(module) {
  return module.replace(/`[^`]*`/, (styles) => styles.replace(IDLE, '$1').replace(/;}/g, '}'));
}
