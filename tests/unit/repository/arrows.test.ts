/** `npm test -- arrows` rejects imports against the arrows of ARCHITECTURE.md, and cycles. */
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { script } from '../../support/server.ts';

const { checkImports } = await script<{ checkImports(folder: string): string[] }>('lint/imports.mjs');

let folder: string;
beforeEach(() => (folder = mkdtempSync(join(tmpdir(), 'cartoon-smoke-'))));
afterEach(() => rmSync(folder, { recursive: true }));

function check(files: Readonly<Record<string, string>>): string[] {
  for (const [path, code] of Object.entries(files)) {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    writeFileSync(join(folder, path), code);
  }
  return checkImports(folder);
}

test.each([
  ['a value', `import { value } from '../sim/thing.ts'; export const own = value;`],
  ['a side effect', `import '../sim/thing.ts';`],
  ['a type', `import type { Type } from '../sim/thing.ts'; export type Own = Type;`],
  ['a type in place', `export type Own = import('../sim/thing.ts').Type;`],
  ['a value on demand', `export const late = () => import('../sim/thing.ts');`],
  ['a value passed on', `export { value } from '../sim/thing.ts';`],
  ['all that is passed on', `export * from '../sim/thing.ts';`],
  ['a path without its ending', `export { value } from '../sim/thing';`],
  ['a path from the top', `export { value } from '/src/sim/thing.ts';`],
  ['a path the long way', `export { value } from '../../src/sim/thing.ts';`],
  ['a file of the package', `export { value } from '../index.ts';`],
  ['a folder', `export { value } from '..';`],
  ['a package', `import { value } from 'lean-qr'; export const own = value;`],
])('passes cannot import %s', (_, code) => {
  expect(check({ 'passes/user.ts': code })).toEqual([
    expect.stringMatching(/^src\/passes\/user\.ts must not import \S+\.$/),
  ]);
});

test.each([
  ['sim', `import { Vector3 } from 'three'; export const own = new Vector3();`, 1],
  ['sim', `import type { Vector3 } from 'three/webgpu'; export type Own = Vector3;`, 1],
  ['passes', `import { Color } from 'three'; export const own = new Color();`, 0],
  ['passes', `import { own } from './deeper/other.ts'; export { own };`, 0],
  ['passes', `import shader from '../../shaders/mask/mask.frag'; export const own = shader;`, 0],
  ['passes', `import { SHARED } from '../constants.ts'; export const own = SHARED;`, 0],
  ['rows', `import type { Type } from '../sim/thing.ts'; export type Own = Type;`, 0],
  ['rows', `export { value } from '../sim/thing.ts';`, 1],
  ['device', `import { Problem } from '../preset/errors.ts'; export const own = new Problem();`, 0],
  ['device', `import { table } from '../preset/table.ts'; export const own = table;`, 1],
  ['app', `export const late = () => import('../sim/thing.ts');`, 1],
  ['app', `export { value } from '../internal.ts';`, 0],
  ['unknown', `export { value } from '../preset/thing.ts';`, 1],
])('src/%s: %s is rejected %i times', (from, code, count) => {
  expect(check({ [`${from}/user.ts`]: code })).toHaveLength(count);
});

test.each([
  ['imports', `import { a } from './a.ts'; export const c = () => a;`],
  ['types', `import type { a } from './a.ts'; export type C = typeof a;`],
  ['imports on demand', `export const c = () => import('./a.ts');`],
])('a cycle of %s is rejected', (_, code) => {
  const files = {
    'puffs/a.ts': `import { b } from './b.ts'; export const a = () => b;`,
    'puffs/b.ts': `export * from './c.ts'; export const b = 1;`,
    'puffs/c.ts': code,
  };
  expect(check(files)).toEqual(['These files form a cycle: puffs/a.ts -> puffs/b.ts -> puffs/c.ts -> puffs/a.ts.']);
});
