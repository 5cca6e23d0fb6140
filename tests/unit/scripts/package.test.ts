/** The npm package, as checkers and servers see it. */
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { publint } from 'publint';
import { beforeAll, expect, it } from 'vitest';
import { names } from '../../../src/page/element/attributes/names.ts';
import { CartoonSmokeElement } from '../../../src/page/element/cartoonSmokeElement.ts';
import { presets } from '../../../src/parameters/words/presets.ts';
import { table } from '../../../src/parameters/words/table.ts';
import { hiddenTypes } from './signatures.ts';

interface PackageScript {
  /** The tarball's name. */
  ARCHIVE: string;
  isFresh(): boolean;
  bring(say: () => void): Promise<void>;
}

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const FOLDER = join(ROOT, 'package');
/** Path of the tarball. */
let archive: string;

beforeAll(async () => {
  const script = (await import(pathToFileURL(join(ROOT, 'scripts/setup/package.mjs')).href)) as PackageScript;
  if (!script.isFresh()) await script.bring(() => undefined);
  archive = join(ROOT, script.ARCHIVE);
});

it('is also written as one tarball next to the folder, which git ignores', () => {
  const { version: ofPackage } = JSON.parse(readFileSync(join(FOLDER, 'package.json'), 'utf8')) as { version: string };
  expect(archive).toBe(join(ROOT, `cartoon-smoke-${ofPackage}.tgz`));
  const listed = execFileSync('tar', ['-tzf', archive], { encoding: 'utf8' }).trim().split('\n');
  const entries = readdirSync(FOLDER, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const files = entries.map(({ parentPath, name }) => join(parentPath, name).slice(ROOT.length));
  expect(listed.sort()).toEqual(files.map((file) => file.replaceAll('\\', '/')).sort());
  expect(execFileSync('git', ['check-ignore', archive], { cwd: ROOT, encoding: 'utf8' }).trim()).toBe(archive);
});

it('has valid exports and files for npm and bundlers', async () => {
  const { messages } = await publint({ pkgDir: FOLDER, pack: 'npm' });
  expect(messages).toEqual([]);
});

it('links to the repository of package.json, its homepage and its issues', () => {
  const manifestIn = (folder: string) =>
    JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')) as Record<string, unknown>;
  const [host, path] = (manifestIn(ROOT).repository as string).split(':');
  const address = `https://${host}.com/${path}`;
  expect(manifestIn(FOLDER)).toMatchObject({
    repository: { type: 'git', url: `git+${address}.git` },
    homepage: `${address}#readme`,
    bugs: { url: `${address}/issues` },
  });
});

it('exports by name each type that a public signature names', () => {
  const { hidden, exported } = hiddenTypes(join(FOLDER, 'types'), [
    'index.d.ts',
    'preset.d.ts',
    'element.d.ts',
    'fiber.d.ts',
  ]);
  expect(hidden).toEqual([]);
  expect(exported).toBeGreaterThan(80);
});

it('has types that reject unknown keys, values and presets', () => {
  const folder = join(ROOT, '.cache/typeCases');
  mkdirSync(folder, { recursive: true });
  const cases = readFileSync(join(ROOT, 'tests/unit/scripts/typeCases.ts'), 'utf8');
  const types = join(FOLDER, 'types');
  writeFileSync(join(folder, 'cases.ts'), cases.replace(/'[./]+src\/(.*)\.ts'/g, `'${types}/$1.js'`));
  writeFileSync(
    join(folder, 'markup.ts'),
    `import type { SmokeAttributes } from '${types}/page/element/attributes.js';
export const accepted: SmokeAttributes = { preset: 'wisp', 'emission-rate': 3, 'style-gradient': 'height' };
export const rejected: SmokeAttributes[] = [
  // @ts-expect-error no such preset
  { preset: 'lampp' },
  // @ts-expect-error no such attribute
  { 'emission-rates': 3 },
  // @ts-expect-error no such option
  { 'style-gradient': 'rainbow' },
];
`,
  );
  const options = { strict: true, noEmit: true, moduleResolution: 'bundler', module: 'ESNext', target: 'ES2023' };
  // Projects with these options also check the declarations of packages.
  const strictest = { exactOptionalPropertyTypes: true, skipLibCheck: false };
  const config = { compilerOptions: { ...options, ...strictest, types: [] }, include: ['.'] };
  writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify(config));
  const { stdout } = spawnSync(process.execPath, [join(ROOT, 'node_modules/typescript/bin/tsc'), '-p', folder]);
  expect(String(stdout)).toBe('');
});

const WARNING = ['index', 'element', 'fiber', 'puff'].map((name) => `development/${name}`);

it.each(['index', 'element', 'fiber', 'preset', ...WARNING])('can import %s without a DOM', (name) => {
  const address = pathToFileURL(join(FOLDER, `dist/${name}.js`)).href;
  const program = `import(${JSON.stringify(address)}).then((module) => console.log(Object.keys(module).length))`;
  const said = execFileSync(process.execPath, ['--eval', program], { cwd: ROOT, encoding: 'utf8' });
  expect(Number(said)).toBeGreaterThan(0);
});

it('has a source map for each module, and no texts of parameters and presets in the code of widgets', () => {
  const files = readdirSync(join(FOLDER, 'dist'));
  // Code that the bundler adds has no sources, and neither has a module that passes on the exports of another.
  const hasSources = (file: string) =>
    !file.endsWith('rolldown-runtime.js') && !/^export\{[^}]*\}from"[^"]*";\s*$/.test(codeOf(file));
  const codeOf = (file: string) => readFileSync(join(FOLDER, 'dist', file), 'utf8');
  // Scripts that are not minified need no source map.
  const isPlain = (file: string) => file.endsWith('.development.js');
  const modules = files.filter((file) => file.endsWith('.js') && !isPlain(file) && hasSources(file));
  expect(modules.filter((file) => !files.includes(`${file}.map`))).toEqual([]);
  const codes = new Map(modules.map((file) => [file, codeOf(file)]));
  const wordy = (rows: readonly { text: string }[]) =>
    modules.filter((file) => rows.some(({ text }) => codes.get(file)?.includes(text)));
  expect(wordy(table)).toEqual(['preset.js']);
  // Both export the presets.
  expect(wordy(presets)).toEqual(['index.js', 'preset.js']);
});

it('contains React in the module of React Three Fiber only', () => {
  const dist = join(FOLDER, 'dist');
  const built = readdirSync(dist).filter((file) => file.endsWith('.js'));
  const usesReact = (file: string) =>
    /['"](react|@react-three\/fiber)['"/]/.test(readFileSync(join(dist, file), 'utf8'));
  expect(built.filter(usesReact)).toEqual(['fiber.js']);
  expect(readFileSync(join(dist, 'fiber.js'), 'utf8')).toMatch(/^["']use client["']/);
});

it('contains the warnings of development builds only in their files', () => {
  const sources = ['stage/remote', 'page/element', 'page/puff', 'three'].map((folder) => `src/${folder}/warnings.ts`);
  const texts = [...sources, 'src/base/warn.ts'].flatMap((file) => {
    const code = readFileSync(join(ROOT, file), 'utf8').replace(/\/\*[^]*?\*\/|\/\/.*/g, '');
    return code.match(/\b[A-Z]\w*(?: (?!extends)[\w(),]+){3,}/g) ?? [];
  });
  expect(texts.length).toBeGreaterThan(10);
  const dist = join(FOLDER, 'dist');
  const built = readdirSync(dist, { recursive: true, encoding: 'utf8' }).filter((file) => file.endsWith('.js'));
  const codeOf = (file: string) => readFileSync(join(dist, file), 'utf8');
  const [warning, others] = [true, false].map((isWarning) =>
    built.filter((file) => /development/.test(file) === isWarning).map((file) => ({ file, code: codeOf(file) })),
  );
  expect(texts.filter((text) => !warning.some(({ code }) => code.includes(text)))).toEqual([]);
  expect(others.filter(({ code }) => /development\//.test(code) || texts.some((text) => code.includes(text)))).toEqual(
    [],
  );
});

it('contains no fault injection', () => {
  const faults = [...readFileSync(join(ROOT, 'src/renderer/gpu/faults.ts'), 'utf8').matchAll(/^ \* - `(\w+)`/gm)];
  expect(faults).toHaveLength(3);
  const dist = join(FOLDER, 'dist');
  const built = readdirSync(dist).filter((file) => file.endsWith('.js'));
  const knows = (file: string, name: string) => readFileSync(join(dist, file), 'utf8').includes(name);
  expect(built.filter((file) => faults.some(([, name]) => knows(file, name)))).toEqual([]);
});

it('lists the bundled packages and linked crates with their licences', () => {
  const text = readFileSync(join(FOLDER, 'dist/third-party-licenses.txt'), 'utf8');
  for (const name of ['three', 'rapier3d', 'glam', 'wasm-bindgen']) {
    expect(text).toMatch(new RegExp(`^${name} \\d+\\.\\d+\\.\\d+ \\([^\n]+\\)\nhttps://`, 'm'));
  }
});

it('has an element with the version of the package', () => {
  const { version: ofPackage } = JSON.parse(readFileSync(join(FOLDER, 'package.json'), 'utf8')) as { version: string };
  expect(CartoonSmokeElement.version).toBe(ofPackage);
});

interface Described {
  name: string;
  attributes: {
    name: string;
    pattern?: string;
    description: string;
    values?: { name: string }[];
    value?: { type: string };
  }[];
}

it('describes the same attributes to all editors', () => {
  const read = (file: string): unknown => JSON.parse(readFileSync(join(FOLDER, file), 'utf8'));
  const { modules } = read('custom-elements.json') as { modules: { declarations: Described[] }[] };
  const [manifest] = modules[0].declarations;
  const [code] = (read('html-custom-data.json') as { tags: Described[] }).tags;
  const types = read('web-types.json') as { contributions: { html: { elements: Described[] } }; version: string };
  const [web] = types.contributions.html.elements;
  expect(types.version).toBe(CartoonSmokeElement.version);
  const texts = (all: Described['attributes']) => all.map(({ name, description }) => [name, description]);
  const single = manifest.attributes.filter(({ name }) => !/-\d-/.test(name));
  expect(single.length).toBeLessThan(manifest.attributes.length / 2);
  expect([code.name, web.name]).toEqual(['cartoon-smoke', 'cartoon-smoke']);
  expect(texts(code.attributes)).toEqual(texts(single));
  expect(texts(web.attributes.filter(({ pattern }) => !pattern))).toEqual(texts(single));
  const patterns = web.attributes.flatMap(({ pattern }) => (pattern ? [new RegExp(`^${pattern}$`)] : []));
  const listed = names.filter(({ key }) => /^\w+\.\d\./.test(key));
  expect(listed.filter(({ attribute }) => patterns.filter((one) => one.test(attribute)).length !== 1)).toEqual([]);
  expect(listed).toHaveLength(8 * patterns.length);
  const of = (element: Described, wanted: string) => element.attributes.find(({ name }) => name === wanted)!;
  expect(of(code, 'loading').values).toEqual([{ name: 'lazy' }, { name: 'eager' }]);
  expect(of(web, 'loading').value!.type).toBe("'lazy' | 'eager'");
  expect(of(web, 'emission-rate').value!.type).toBe('number');
});

it('types the attributes of list items as patterns', () => {
  const declared = readFileSync(join(FOLDER, 'types/page/element/attributes.d.ts'), 'utf8');
  const written = names.filter(({ attribute }) => declared.includes(`'${attribute}'?`));
  expect(written.filter(({ key }) => /^\w+\.\d\./.test(key))).toEqual([]);
  const patterns = [...declared.matchAll(/\[attribute: `(.+)`\]/g)].map(([, pattern]) =>
    pattern.replace('${number}', '5'),
  );
  const listed = names.filter(({ key }) => /^\w+\.5\./.test(key)).map(({ attribute }) => attribute);
  expect(patterns.sort()).toEqual(listed.sort());
  expect(written.length + 8 * patterns.length).toBe(names.length);
});

it('has a manifest of the element with all parameters', () => {
  const manifest = JSON.parse(readFileSync(join(FOLDER, 'custom-elements.json'), 'utf8'));
  const attributes = new Set(manifest.modules[0].declarations[0].attributes.map(({ name }: { name: string }) => name));
  const missing = names.filter(({ key, attribute }) => !/^\w+\.[1-7]\./.test(key) && !attributes.has(attribute));
  expect(missing).toEqual([]);
});
