/** A test file outside all runners' folders would always pass, and a citation of a missing file proves nothing. */
import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename, dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));

/** Paths of all files in a folder, relative to it. */
function filesIn(folder: string): string[] {
  const paths = readdirSync(`${ROOT}/${folder}`, { recursive: true, encoding: 'utf8' });
  return paths.map((path) => path.replaceAll('\\', '/'));
}

test('every test file is in a folder that a runner searches', () => {
  const files = filesIn('tests');
  const tests = files.filter((path) => /[.](test|spec)\.[cm]?[jt]sx?$/.test(path));
  const camelCase = String.raw`[a-z][a-zA-Z0-9]*(\.long)?`;
  const found = new RegExp(
    String.raw`^(unit|engines)/(\w+/)*${camelCase}\.test\.ts$|^(site|visual|e2e)/(\w+/)*${camelCase}\.spec\.ts$`,
  );
  expect(tests.filter((path) => !found.test(path))).toEqual([]);
  expect(tests.length).toBeGreaterThan(0);
});

test('no folder has more than 25 source files of its own', () => {
  const list = execFileSync('git', ['ls-files'], { cwd: ROOT, encoding: 'utf8' }).split('\n');
  const sizes = new Map<string, number>();
  for (const path of list.filter((name) => /\.(ts|mjs|rs|glsl|vert|frag|css)$/.test(name))) {
    sizes.set(dirname(path), (sizes.get(dirname(path)) ?? 0) + 1);
  }
  expect(sizes.size).toBeGreaterThan(50);
  expect([...sizes].filter(([, files]) => files > 25)).toEqual([]);
});

test('every test file that a comment or a document cites exists', () => {
  const crates = readdirSync(`${ROOT}/sim-wasm`).map((crate) => `sim-wasm/${crate}/src`);
  const folders = ['src', 'shaders', 'docs', ...crates].filter((folder) => existsSync(`${ROOT}/${folder}`));
  const files = folders.flatMap((folder) => filesIn(folder).map((path) => `${folder}/${path}`));
  const sources = files.filter((path) => /\.(md|ts|rs|glsl|vert|frag|css)$/.test(path));
  const texts = [...readdirSync(ROOT).filter((path) => path.endsWith('.md')), ...sources];
  const names = new Set(['tests', 'sim-wasm/sim/tests'].flatMap(filesIn).map((path) => basename(path)));
  // A path relative to the root or to the crate `sim`, or only the file name.
  const isThere = (cited: string) =>
    cited.includes('/')
      ? existsSync(`${ROOT}/${cited}`) || existsSync(`${ROOT}/sim-wasm/sim/${cited}`)
      : names.has(cited);
  const citations = texts.flatMap((path) => {
    const text = readFileSync(`${ROOT}/${path}`, 'utf8');
    const cited = text.match(/[\w./-]*tests\/[\w./-]+\.(?:ts|mjs|rs)\b|[\w.-]+\.(?:test|spec|cases)\.ts\b/g) ?? [];
    return cited.map((file) => ({ path, file }));
  });
  expect(citations.length).toBeGreaterThan(10);
  expect(citations.filter(({ file }) => !isThere(file))).toEqual([]);
});
