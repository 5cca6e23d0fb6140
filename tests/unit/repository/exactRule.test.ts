/** The linter rejects engine-dependent numbers where they reach the simulator, and only there. */
import { spawnSync } from 'node:child_process';
import { copyFileSync, symlinkSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { Project } from '../../support/project.ts';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));

let project: Project;
beforeEach(() => {
  project = new Project();
  copyFileSync(`${ROOT}/.oxlintrc.json`, project.path('.oxlintrc.json'));
  symlinkSync(`${ROOT}/node_modules`, project.path('node_modules'));
});
afterEach(() => project.dispose());

/** The errors of the custom lint rules, for files and their code. */
function errors(files: Readonly<Record<string, string>>): string[] {
  for (const [path, code] of Object.entries(files)) project.write(path, code);
  const oxlint = `${ROOT}/node_modules/oxlint/bin/oxlint`;
  const { stdout } = spawnSync(process.execPath, [oxlint, '--format=unix', 'src'], {
    cwd: project.folder,
    encoding: 'utf8',
  });
  return stdout.split('\n').filter((line) => line.includes('Error/exact'));
}

const REJECTED = [
  ...'sin cos tan asin acos atan atan2 exp expm1 log log2 log10 log1p pow hypot cbrt sinh tanh random'
    .split(' ')
    .map((name) => [`Math.${name}`, `export const own = Math.${name}();`]),
  ['Math.sin', `export const own = Math['sin'](1);`],
  ['Math itself', `const { sin } = Math; export const own = sin(1);`],
  ['Math itself', `export const own = globalThis.Math.sin(1);`],
  ['operator **', `export const own = (a: number) => a ** 2;`],
  ['operator **=', `export const own = (a: number) => { let b = a; b **= 2; return b; };`],
  ['Quaternion of three.js', `import { Quaternion } from 'three'; export const own = new Quaternion();`],
  ['Euler of three.js', `import { Euler as E } from 'three'; export const own = new E();`],
  ['all of three.js', `import * as three from 'three'; export const own = new three.Euler();`],
] as const;

test('each inexact function is rejected in scenes, with the reason', () => {
  const files = REJECTED.map(([, code], index) => [`src/scenes/user${index}.ts`, `${code}\n`]);
  const lines = errors(Object.fromEntries(files) as Record<string, string>);
  expect(lines).toHaveLength(REJECTED.length);
  for (const [index, [what]] of REJECTED.entries()) {
    const line = lines.find((said) => said.includes(`user${index}.ts`));
    expect(line).toContain(what);
    expect(line).toMatch(/last bits differ between engines.*src\/simulator\/exact/);
  }
});

test('functions that are exact by definition are accepted', () => {
  const code = `
    import { Vector3, type Quaternion } from 'three';
    export const way = (turn: Quaternion) => new Vector3(turn.x, Math.PI, Math.SQRT2);
    export const own = (a: number) => Math.sqrt(Math.abs(a % 3) + Math.min(Math.floor(a), Math.max(Math.round(a), 1)));
  `;
  expect(errors({ 'src/scenes/user.ts': code })).toEqual([]);
});

test('the rules apply to all code that feeds the simulator, and to no other', () => {
  const code = 'export const own = Math.sin(1);\n';
  const fed = ['scenes/models/a.ts', 'simulator/a.ts', 'parameters/a.ts', 'stage/simulation.ts'];
  const free = ['stage/orbit.ts', 'renderer/passes/a.ts', 'three/a.ts', 'demo/a.ts'];
  const lines = errors(Object.fromEntries([...fed, ...free].map((path) => [`src/${path}`, code])));
  expect(lines.map((line) => /src\/([^:]*):/.exec(line)![1]).toSorted()).toEqual(fed.toSorted());
});
