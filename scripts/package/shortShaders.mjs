/**
 * Minifies shaders for the package: removes comments and white space, and shortens local names to one or two letters. A
 * name is shortened identically in all shaders, so that shared declarations match and compress together. Uniforms,
 * attributes and macros keep their names, because TypeScript uses them.
 */

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import glsl from 'vite-plugin-glsl';
import { inRoot } from '../lib/paths.mjs';

/** @typedef {{ file: string, text: string }} Shader */

/** An identifier that is not a component or a part of a number. */
const NAME = /(?<![\w.])[A-Za-z_]\w*/g;
/** By their frequency in GLSL: frequent letters compress better. */
const LETTERS = [...'etaoirnslcdpumfhvgxywbkzqjATSCDEPMIRNLOFVBGUWHXKYQZJ'];

/** The bundler plugin that loads the shaders. */
export function shortShaders() {
  const names = shortNames(shadersIn('shaders'));
  return glsl({ minify: true, onComplete: (shader) => shortened(shader, names) });
}

/**
 * A bundler plugin that groups the shaders of a file, because gzip finds repetitions only within the last 32 kB.
 * @returns {import('rolldown').Plugin}
 */
export function shadersTogether() {
  return {
    name: 'shaders-together',
    renderChunk(code, _chunk, _options, { magicString }) {
      if (!magicString) throw new Error('Shaders together need experimental.nativeMagicString.');
      const shaders = [...code.matchAll(/^\/\/ shaders\/.*\nvar [\w$]+ = ".*";\n/gm)];
      // Short ones first: a long one then follows the one that it has most in common with.
      shaders.sort(({ 0: one }, { 0: other }) => one.length - other.length);
      for (const { 0: shader, index } of shaders) if (index > 0) magicString.move(index, index + shader.length, 0);
      return { code: magicString };
    },
  };
}

/** Left over by the plugin's own minifier: redundant zeros, and white space beside some operators. */
const IDLE = /(?<![\w.])0(?=\.\d*[1-9])|(?<=\d\.)0+(?!\w)| (?=[?:%^])|(?<=[?:%^]) |(?<!-) (?=-)|(?<=-) (?!-)/g;

/**
 * @param {string} shader without comments
 * @param {ReadonlyMap<string, string>} names
 */
function shortened(shader, names) {
  return shader.replace(NAME, (name) => names.get(name) ?? name).replace(IDLE, '');
}

/**
 * @param {string} folder
 * @returns {Shader[]}
 */
function shadersIn(folder) {
  const files = readdirSync(inRoot(folder), { recursive: true, encoding: 'utf8' }).filter((file) => file.includes('.'));
  return files.map((file) => ({
    file,
    text: readFileSync(join(inRoot(folder), file), 'utf8').replace(/\/\/.*|^ *#include.*/gm, ''),
  }));
}

/**
 * Short names for identifiers that only shaders declare and use; the most frequent ones get the shortest.
 *
 * @param {Shader[]} shaders
 * @returns {Map<string, string>}
 */
export function shortNames(shaders) {
  const counts = countNames(shaders);
  const reserved = reservedNames(shaders);
  const renamed = [...declaredNames(shaders)].filter((name) => name.length > 2 && !reserved.has(name));
  renamed.sort((one, other) => (counts.get(other) ?? 0) - (counts.get(one) ?? 0) || (one < other ? -1 : 1));
  const free = freeNames(counts);
  return new Map(renamed.map((name) => [name, /** @type {string} */ (free.next().value)]));
}

/** @param {Shader[]} shaders */
function countNames(shaders) {
  /** @type {Map<string, number>} */
  const counts = new Map();
  for (const [name] of found(shaders, NAME)) counts.set(name, (counts.get(name) ?? 0) + 1);
  return counts;
}

/**
 * Functions, their parameters, variables and constants.
 * @param {Shader[]} shaders
 */
function declaredNames(shaders) {
  const structs = [...found(shaders, /\bstruct (\w+)/g)].map(([, name]) => name);
  const type = ['void', 'float', 'u?int', 'bool', '[iub]?vec[234]', 'mat[234]', ...structs].join('|');
  return new Set([...structs, ...secondsOf(shaders, new RegExp(`\\b(?:${type}) (\\w+)`, 'g'))]);
}

/**
 * Names used outside the shaders' own declarations: in TypeScript, structs, GLSL, or macros that call them.
 * @param {Shader[]} shaders
 */
function reservedNames(shaders) {
  const uniforms = secondsOf(shaders, /\buniform (?:highp )?\w+ (\w+)/g);
  const attributes = secondsOf(
    shaders.filter(({ file }) => file.endsWith('.vert')),
    /^in \w+ (\w+)/gm,
  );
  const members = [...found(shaders, /\bstruct \w+ \{([^}]*)/g)].flatMap(([, body]) => body.match(/\w+(?=;)/g) ?? []);
  const defined = new Set(secondsOf(shaders, /^\w+ (\w+)\(/gm));
  const called = new Set(secondsOf(shaders, /(?<!^\w+ )\b(\w+)\(/gm));
  const ofOneSide = [...called]
    .filter((name) => !defined.has(name))
    .concat([...defined].filter((name) => !called.has(name)));
  return new Set([...uniforms, ...attributes, ...members, ...ofOneSide]);
}

/**
 * @param {Shader[]} shaders
 * @param {RegExp} pattern
 */
function secondsOf(shaders, pattern) {
  return [...found(shaders, pattern)].map(([, name]) => name);
}

/**
 * @param {Shader[]} shaders
 * @param {RegExp} pattern
 */
function* found(shaders, pattern) {
  for (const { text } of shaders) yield* text.matchAll(pattern);
}

/**
 * One and two-letter names that no shader uses.
 * @param {ReadonlyMap<string, number>} taken
 */
function* freeNames(taken) {
  const rank = (/** @type {string} */ pair) => LETTERS.indexOf(pair[0]) + LETTERS.indexOf(pair[1]);
  const pairs = LETTERS.flatMap((first) => LETTERS.map((second) => first + second));
  pairs.sort((one, other) => rank(one) - rank(other));
  yield* [...LETTERS, ...pairs].filter((name) => !taken.has(name) && !['if', 'in', 'do'].includes(name));
}
