/**
 * `npm test -- arrows`: imports between the folders of src/ go in one direction, and no files form a cycle. Types,
 * `import()` and exports of other files count as imports.
 */

import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseSync, Visitor } from 'rolldown/utils';
import { inRoot } from '../lib/paths.mjs';

const RENDERER = 'renderer renderer/gpu renderer/passes renderer/puffs';

/**
 * What a folder imports besides itself: folders without those of their own line, files at the top of src/, and packages
 * as `npm:name`. `type:` accepts only types. Files at the top of src/ import what they want.
 *
 * @type {Record<string, string>}
 */
export const ARROWS = {
  base: '',
  parameters: 'base npm:jsonc-parser',
  simulator: 'base parameters',
  'renderer/puffs': 'base',
  'renderer/gpu': 'base type:renderer/puffs type:simulator npm:three',
  'renderer/passes': 'base parameters renderer/gpu npm:three',
  renderer: `base parameters simulator ${RENDERER} npm:three`,
  scenes: `base parameters simulator ${RENDERER} npm:three`,
  stage: `base parameters simulator ${RENDERER} scenes npm:three`,
  'stage/remote': `base parameters simulator ${RENDERER} scenes stage`,
  three: `base parameters simulator ${RENDERER} npm:three`,
  'three/fiber': 'base parameters simulator three npm:three npm:react npm:@react-three/fiber',
  page: 'base parameters simulator stage',
  'page/outline': 'base renderer/puffs',
  'page/puff': `base parameters simulator ${RENDERER} stage stage/remote page page/outline`,
  'page/element': `base parameters simulator ${RENDERER} stage stage/remote page`,
  'page/clip': `base parameters simulator ${RENDERER} stage npm:three npm:gifenc`,
  'page/iframe': 'base parameters simulator stage/remote page page/element',
  demo: 'index.ts preset.ts puff.ts internal.ts npm:three npm:culori npm:fflate npm:lean-qr npm:mediabunny',
};

/**
 * @typedef {object} Import
 * @property {string} to path relative to src/, or the name of a package after `npm:`
 * @property {boolean} isType
 */

/**
 * @param {string} folder with the content of src/
 * @returns {string[]} a sentence for each forbidden import and each cycle
 */
export function checkImports(folder) {
  const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).map((path) => path.replaceAll('\\', '/'));
  const sources = files.filter((path) => /(?<!\.d)\.tsx?$/.test(path)).sort();
  const graph = new Map(sources.map((path) => [path, importsOf(path, readFileSync(join(folder, path), 'utf8'))]));
  const forbidden = [...graph].flatMap(([from, imports]) =>
    imports.filter((each) => !isAllowed(from, each)).map(({ to }) => `src/${from} must not import ${to}.`),
  );
  return [...forbidden, ...cyclesIn(graph).map((cycle) => `These files form a cycle: ${cycle.join(' -> ')}.`)];
}

/**
 * @param {string} path
 * @param {string} code
 */
function importsOf(path, code) {
  /** @type {Import[]} */
  const found = [];
  const add = (/** @type {any} */ source, /** @type {boolean} */ isType) => {
    if (typeof source?.value !== 'string') return;
    const [name] = source.value.split('?');
    const [scope, ...rest] = name.split('/');
    if (name.startsWith('/')) found.push({ to: name, isType });
    else if (name.startsWith('.')) found.push({ to: join(dirname(path), name).replaceAll('\\', '/'), isType });
    else found.push({ to: `npm:${scope.startsWith('@') ? `${scope}/${rest[0]}` : scope}`, isType });
  };
  const { program, errors } = parseSync(path, code);
  if (errors.length > 0) throw new Error(`src/${path}: ${errors[0].message}`);
  new Visitor({
    ImportDeclaration: ({ source, importKind }) => add(source, importKind === 'type'),
    ExportNamedDeclaration: ({ source, exportKind }) => add(source, exportKind === 'type'),
    ExportAllDeclaration: ({ source, exportKind }) => add(source, exportKind === 'type'),
    ImportExpression: ({ source }) => add(source, false),
    TSImportType: ({ source }) => add(source, true),
  }).visit(program);
  return found;
}

/**
 * @param {string} from
 * @param {Import} target
 */
function isAllowed(from, { to, isType }) {
  const [own, other] = [from, to].map(roomOf);
  // A path without an ending would resolve to an index file.
  if (to.startsWith('/') || (!to.startsWith('npm:') && !/\.\w+$/.test(to))) return false;
  // Shaders are outside of src/.
  if (to.startsWith('../')) return !to.startsWith('../src/');
  if (from === own || other === own) return true;
  const allowed = (ARROWS[own] ?? '').split(' ');
  const names = to.startsWith('npm:') ? [to] : [to, other];
  return [...names, ...(isType ? names.map((name) => `type:${name}`) : [])].some((name) => allowed.includes(name));
}

/** The folder with a line in ARROWS that contains a file, otherwise the one at the top. */
function roomOf(/** @type {string} */ path) {
  const [first, second] = path.split('/');
  const inner = `${first}/${second}`;
  return inner in ARROWS ? inner : first;
}

/**
 * @param {Map<string, Import[]>} graph
 * @returns {string[][]} one cycle for each import that closes one, with its first file at both ends
 */
function cyclesIn(graph) {
  /** @type {string[][]} */
  const cycles = [];
  /** @type {string[]} */
  const way = [];
  const done = new Set();
  const visit = (/** @type {string} */ file) => {
    if (way.includes(file)) cycles.push([...way.slice(way.indexOf(file)), file]);
    if (done.has(file) || way.includes(file)) return;
    way.push(file);
    for (const { to } of graph.get(file) ?? []) visit(to);
    way.pop();
    done.add(file);
  };
  for (const file of graph.keys()) visit(file);
  return cycles;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const problems = checkImports(inRoot('src'));
  for (const problem of problems) console.error(problem);
  process.exitCode = problems.length > 0 ? 1 : 0;
}
