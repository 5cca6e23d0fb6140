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
  ['a value', `import { value } from '../../simulator/thing.ts'; export const own = value;`],
  ['a side effect', `import '../../simulator/thing.ts';`],
  ['a type', `import type { Type } from '../../simulator/thing.ts'; export type Own = Type;`],
  ['a type in place', `export type Own = import('../../simulator/thing.ts').Type;`],
  ['a value on demand', `export const late = () => import('../../simulator/thing.ts');`],
  ['a value passed on', `export { value } from '../../simulator/thing.ts';`],
  ['all that is passed on', `export * from '../../simulator/thing.ts';`],
  ['a path without its ending', `export { value } from '../../simulator/thing';`],
  ['a path from the top', `export { value } from '/src/simulator/thing.ts';`],
  ['a path the long way', `export { value } from '../../../src/simulator/thing.ts';`],
  ['a file of the package', `export { value } from '../../index.ts';`],
  ['a folder', `export { value } from '..';`],
  ['a package', `import { value } from 'lean-qr'; export const own = value;`],
])('passes cannot import %s', (_, code) => {
  expect(check({ 'renderer/passes/user.ts': code })).toEqual([
    expect.stringMatching(/^src\/renderer\/passes\/user\.ts must not import \S+\.$/),
  ]);
});

test.each([
  ['simulator', `import { Vector3 } from 'three'; export const own = new Vector3();`, 1],
  ['simulator', `import type { Vector3 } from 'three/webgpu'; export type Own = Vector3;`, 1],
  ['renderer/passes', `import { Color } from 'three'; export const own = new Color();`, 0],
  ['renderer/passes', `import { own } from './deeper/other.ts'; export { own };`, 0],
  ['renderer/passes', `import { own } from '../frame.ts'; export { own };`, 1],
  ['renderer/passes', `import shader from '../../../shaders/mask/mask.frag'; export const own = shader;`, 0],
  ['renderer/passes', `import { SHARED } from '../../base/constants.ts'; export const own = SHARED;`, 0],
  ['renderer/gpu', `import type { Type } from '../../simulator/thing.ts'; export type Own = Type;`, 0],
  ['renderer/gpu', `export { value } from '../../simulator/thing.ts';`, 1],
  ['stage', `export { value } from './remote/thing.ts';`, 1],
  ['stage/remote', `export { value } from '../thing.ts';`, 0],
  ['three', `export { value } from '../stage/thing.ts';`, 1],
  ['page', `export { value } from './element/thing.ts';`, 1],
  ['page/puff', `export { value } from '../thing.ts';`, 0],
  ['page/puff', `export { value } from '../element/thing.ts';`, 1],
  ['demo', `export const late = () => import('../simulator/thing.ts');`, 1],
  ['demo', `export { value } from '../internal.ts';`, 0],
  ['unknown', `export { value } from '../parameters/thing.ts';`, 1],
])('src/%s: %s is rejected %i times', (from, code, count) => {
  expect(check({ [`${from}/user.ts`]: code })).toHaveLength(count);
});

test.each([
  ['imports', `import { a } from './a.ts'; export const c = () => a;`],
  ['types', `import type { a } from './a.ts'; export type C = typeof a;`],
  ['imports on demand', `export const c = () => import('./a.ts');`],
])('a cycle of %s is rejected', (_, code) => {
  const files = {
    'base/a.ts': `import { b } from './b.ts'; export const a = () => b;`,
    'base/b.ts': `export * from './c.ts'; export const b = 1;`,
    'base/c.ts': code,
  };
  expect(check(files)).toEqual(['These files form a cycle: base/a.ts -> base/b.ts -> base/c.ts -> base/a.ts.']);
});
