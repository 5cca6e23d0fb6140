/** The linter's configuration rejects and accepts imports as the arrows of ARCHITECTURE.md require. */
import { spawnSync } from 'node:child_process';
import { copyFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { Project } from '../../support/project.ts';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const CONFIG = '.oxlintrc.arrows.json';
const FOLDERS =
  'app element fiber iframe puff page remote stage three scenes smoke passes rows puffs sim device preset'.split(' ');

let project: Project;
beforeEach(() => {
  project = new Project();
  copyFileSync(`${ROOT}/${CONFIG}`, project.path(CONFIG));
  for (const folder of FOLDERS)
    project.write(`src/${folder}/thing.ts`, 'export interface Type {}\nexport const value = 1;\n');
  project.write('src/preset/errors.ts', 'export class Problem extends Error {}\n');
  for (const entry of ['index', 'internal', 'preset', 'puff', 'fiber'])
    project.write(`src/${entry}.ts`, `export { value } from './preset/thing.ts';\n`);
});
afterEach(() => project.dispose());

/** The errors of the linter, one line each. */
function lint(): string[] {
  const oxlint = `${ROOT}/node_modules/oxlint/bin/oxlint`;
  const { stdout } = spawnSync(process.execPath, [oxlint, '-c', CONFIG, '--format=unix', 'src'], {
    cwd: project.folder,
    encoding: 'utf8',
  });
  return stdout.split('\n').filter((line) => /\[Error/.test(line));
}

/** Lints one line of code in a folder. */
function lintLine(folder: string, code: string): string[] {
  project.write(`src/${folder}/user.ts`, `${code}\n`);
  return lint();
}

const right: Record<string, string> = {
  app: '',
  fiber: 'three preset',
  iframe: 'element remote stage scenes smoke passes rows puffs sim device preset',
  element: 'page remote stage scenes smoke passes rows puffs sim device preset',
  puff: 'page remote stage scenes smoke passes rows puffs sim device preset',
  page: 'stage sim preset',
  remote: 'stage scenes smoke passes rows puffs sim device preset',
  stage: 'scenes smoke passes rows puffs sim device preset',
  three: 'smoke passes rows puffs sim device preset',
  scenes: 'passes rows puffs sim device preset',
  smoke: 'passes rows puffs sim device preset',
  passes: 'device preset',
  rows: 'device preset',
  puffs: 'device preset',
  sim: 'device preset',
  device: '',
  preset: '',
};

test('every pair of folders is rejected or accepted as documented', () => {
  let expected = 0;
  for (const from of FOLDERS) {
    for (const to of FOLDERS.filter((name) => name !== from)) {
      project.write(
        `src/${from}/uses_${to}.ts`,
        `import { value } from '../${to}/thing.ts';\nexport const own = value;\n`,
      );
      if (!right[from].split(' ').includes(to)) expected++;
    }
  }
  const rejected = new Set(lint().map((line) => /src\/(\w+)\/uses_(\w+)\.ts/.exec(line)?.slice(1).join(' -> ')));
  for (const from of FOLDERS) {
    for (const to of FOLDERS.filter((name) => name !== from)) {
      expect(rejected.has(`${from} -> ${to}`), `${from} -> ${to} is refused`).toBe(
        !right[from].split(' ').includes(to),
      );
    }
  }
  expect(rejected.size).toBe(expected);
});

test.each([
  ['a type', `import type { Type } from '../sim/thing.ts'; export type Own = Type;`],
  ['a value brought late', `export const late = () => import('../sim/thing.ts');`],
  ['a value passed on', `export { value } from '../sim/thing.ts';`],
  ['a path without its ending', `export { value } from '../sim/thing';`],
  ['a path from the top', `export { value } from '/src/sim/thing.ts';`],
  ['a path the long way', `export { value } from '../../src/sim/thing.ts';`],
  ['the index', `export { value } from '../index.ts';`],
  ['the index without its ending', `export { value } from '..';`],
  ['the exports for the page', `export { value } from '../internal.ts';`],
  ['the exports without three.js', `export { value } from '../preset.ts';`],
])('passes cannot import %s of sim', (_, code) => {
  expect(lintLine('passes', code)).toHaveLength(1);
});

test.each([
  ['sim', `import { Vector3 } from 'three'; export const own = new Vector3();`, 1],
  ['sim', `import type { Vector3 } from 'three/webgpu'; export type Own = Vector3;`, 1],
  ['preset', `import { Color } from 'three'; export const own = new Color();`, 1],
  ['passes', `import { Color } from 'three'; export const own = new Color();`, 0],
  ['rows', `import type { Type } from '../sim/thing.ts'; export type Own = Type;`, 0],
  ['rows', `export { value } from '../sim/thing.ts';`, 1],
  ['device', `import type { Type } from '../puffs/thing.ts'; export type Own = Type;`, 0],
  ['device', `export { value } from '../puffs/thing.ts';`, 1],
  ['device', `import { Problem } from '../preset/errors.ts'; export const own = new Problem();`, 0],
  ['app', `import type { Type } from '../sim/thing.ts'; export type Own = Type;`, 1],
  ['app', `export const late = () => import('../sim/thing.ts');`, 1],
  ['app', `export { value } from '../index.ts';`, 0],
  ['app', `export { value } from '../internal.ts';`, 0],
  ['app', `export { value } from '../preset.ts';`, 0],
  ['app', `export { value } from '../puff.ts';`, 0],
  ['element', `export { value } from '../puff.ts';`, 1],
  ['three', `export { value } from '../fiber.ts';`, 1],
  ['app', `export { value } from '../internal';`, 1],
])('src/%s: %s is rejected %i times', (folder, code, count) => {
  expect(lintLine(folder, code)).toHaveLength(count);
});

test('a cycle within a folder is rejected', () => {
  project.write('src/puffs/a.ts', `import { b } from './b.ts';\nexport const a = () => b;\n`);
  project.write('src/puffs/b.ts', `import { a } from './a.ts';\nexport const b = () => a;\n`);
  expect(lint().join()).toMatch(/no-cycle/);
});
