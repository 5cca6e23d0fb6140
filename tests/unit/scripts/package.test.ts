/** The npm package, as checkers and servers see it. */
import { execFileSync, spawnSync } from 'node:child_process';
import {
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { publint } from 'publint';
import { beforeAll, expect, it } from 'vitest';
import { setAssetUrls } from '../../../src/base/setAssetUrls.ts';
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
  expect(listed.sort()).toEqual(
    filesOf('')
      .map((file) => `package/${file}`)
      .sort(),
  );
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

it('exports each file that its code finds by a URL, under its name in setAssetUrls', () => {
  const { exports } = JSON.parse(textOf('package.json')) as {
    exports: Record<string, { types: string; default: string }>;
  };
  const assets = Object.entries(exports).filter(([, { types }]) => types === './types/asset.d.ts');
  const code = filesOf('dist').filter((file) => file.endsWith('.js') && file !== 'dist/cartoon-smoke.min.js');
  const found = code.flatMap((file) =>
    [...textOf(file).matchAll(/new URL\([`'"]\.\/([^`'"]+)[`'"],\s*import\.meta\.url\)/g)].map(([, path]) => path),
  );
  const named = assets.map(([, { default: path }]) => path.slice('./dist/'.length));
  // Clips are encoded on the page's thread where this file does not start as a worker.
  expect([...new Set(found)].sort()).toEqual([...named, 'clipFiles.js'].sort());
  const own = assets.map(([name]) => /^\.\/(\w+)\.\w+$/.exec(name)![1]);
  expect(() => setAssetUrls({ unknown: '' } as object)).toThrow(
    `setAssetUrls.unknown cannot be “”: it takes no value: its options are ${own.join(', ')}.`,
  );
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
  // Projects with this option also check the declarations of packages.
  expectTypes(folder, { skipLibCheck: false });
});

function expectTypes(folder: string, further: object): void {
  const options = { strict: true, noEmit: true, moduleResolution: 'bundler', module: 'ESNext', target: 'ES2023' };
  const all = { ...options, exactOptionalPropertyTypes: true, skipLibCheck: true, types: [], ...further };
  writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify({ compilerOptions: all, include: ['.'] }));
  const { stdout } = spawnSync(process.execPath, [join(ROOT, 'node_modules/typescript/bin/tsc'), '-p', folder]);
  expect(String(stdout)).toBe('');
}

/** Paths of the files in a folder of the package. */
function filesOf(folder: string): string[] {
  const entries = readdirSync(join(FOLDER, folder), { recursive: true, withFileTypes: true });
  const paths = entries.filter((entry) => entry.isFile()).map(({ parentPath, name }) => join(parentPath, name));
  return paths.map((path) => path.slice(FOLDER.length + 1).replaceAll('\\', '/'));
}

function textOf(file: string): string {
  return readFileSync(join(FOLDER, file), 'utf8');
}

const WARNING = ['index', 'clip', 'element', 'fiber', 'puff'].map((name) => `development/${name}`);

it.each(['index', 'clip', 'element', 'fiber', 'preset', ...WARNING])('can import %s without a DOM', (name) => {
  const address = pathToFileURL(join(FOLDER, `dist/${name}.js`)).href;
  const program = `import(${JSON.stringify(address)}).then((module) => console.log(Object.keys(module).length))`;
  const said = execFileSync(process.execPath, ['--eval', program], { cwd: ROOT, encoding: 'utf8' });
  expect(Number(said)).toBeGreaterThan(0);
});

it('is at most 8 MB, without source maps and without references to them', () => {
  const files = filesOf('');
  expect(files.filter((file) => file.endsWith('.map') || textOf(file).includes('sourceMapping'))).toEqual([]);
  const bytes = files.reduce((sum, file) => sum + statSync(join(FOLDER, file)).size, 0);
  expect(bytes).toBeGreaterThan(4e6);
  expect(bytes).toBeLessThanOrEqual(8e6);
});

const DOCUMENTS = ['README.md', 'docs/three.md', 'docs/element.md'];

it('contains its guides, whose links lead to files of the package or to its version in the repository', () => {
  const documents = filesOf('').filter((file) => file.endsWith('.md'));
  expect(documents).toEqual(expect.arrayContaining(DOCUMENTS));
  expect(documents.filter((file) => file.startsWith('docs/design'))).toEqual([]);
  const { version: ofPackage, homepage } = JSON.parse(textOf('package.json')) as { version: string; homepage: string };
  const repository = homepage.replace('#readme', '');
  const seen = { inside: 0, outside: 0 };
  const wrong = documents.flatMap((file) => {
    const text = textOf(file)
      .replace(/^```[^]*?^```/gm, '')
      .replace(/`[^`\n]*`/g, '');
    const targets = [...text.matchAll(/\]\(([^()#\s]+)[^()\s]*\)/g)].map(([, target]) => target);
    return targets.filter((target) => {
      const [, path] = target.split(/\/(?:blob|raw)\/v/);
      if (target.startsWith(repository) && path) {
        ++seen.outside;
        return !path.startsWith(`${ofPackage}/`) || !existsSync(join(ROOT, path.slice(ofPackage.length + 1)));
      }
      ++seen.inside;
      return !target.startsWith('https://') && !existsSync(join(FOLDER, dirname(file), target));
    });
  });
  expect(wrong).toEqual([]);
  expect(seen.inside).toBeGreaterThan(50);
  expect(seen.outside).toBeGreaterThan(20);
});

it('has a README with an example for each entry, which compiles with the types of the package', () => {
  const blocks = [...textOf('README.md').matchAll(/^```(\w+)\n([^]*?)^```/gm)].map(([, language, code]) => ({
    language,
    code,
  }));
  const { exports } = JSON.parse(textOf('package.json')) as { exports: Record<string, unknown> };
  const entries = Object.keys(exports).filter((name) => !/json$|worker|stageModel|development|min\.js/.test(name));
  const missing = entries.filter((name) => {
    const path = `'${name.replace('.', 'cartoon-smoke')}'`;
    return !blocks.some(({ code }) => code.includes(`from ${path}`) || code.includes(`import ${path}`));
  });
  // They differ from `cartoon-smoke/react` in name only.
  expect(missing).toEqual(['./preact', './solid']);
  expect(blocks.filter(({ code }) => code.trim().split('\n').length > 12 && !code.startsWith("'use client'"))).toEqual(
    [],
  );
  const folder = join(ROOT, '.cache/readmeExamples');
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(join(folder, 'node_modules'), { recursive: true });
  symlinkSync(FOLDER, join(folder, 'node_modules/cartoon-smoke'), 'junction');
  const compiled = blocks.filter(({ language }) => /^tsx?$/.test(language));
  expect(compiled).toHaveLength(9);
  for (const [index, { language, code }] of compiled.entries())
    writeFileSync(join(folder, `example${index}.${language}`), code);
  expectTypes(folder, { lib: ['ES2023', 'DOM'], jsx: 'react-jsx' });
});

it('has a command that lists its commands, and the options of each', () => {
  const run = (...words: string[]) => {
    const { status, stdout, stderr } = spawnSync(process.execPath, [join(FOLDER, 'film/command.js'), ...words]);
    return { status, text: `${String(stdout)}${String(stderr)}` };
  };
  const { status, text } = run();
  expect(status).toBe(0);
  expect(run('--help')).toEqual({ status, text });
  const commands = [...text.matchAll(/^ {2}(\w+) {2,}\w/gm)].map(([, name]) => name);
  expect(commands).toEqual(['film', 'flipbook']);
  for (const name of commands) {
    const usage = run(name, '--help');
    expect(usage.status).toBe(0);
    expect(usage.text).toMatch(new RegExp(`^Usage: cartoon-smoke ${name} LINK[^]*--out FOLDER`));
  }
  const [, guides] = /: (\S+)$/.exec(text.trim())!;
  expect(readdirSync(guides)).toContain('film.md');
  const unknown = 'There is no command poster: cartoon-smoke without a command lists them.\n';
  expect(run('poster')).toEqual({ status: 1, text: unknown });
});

it('has no texts of parameters and presets in the code of widgets', () => {
  const codeOf = (file: string) => readFileSync(join(FOLDER, 'dist', file), 'utf8');
  const modules = readdirSync(join(FOLDER, 'dist')).filter((file) => file.endsWith('.js'));
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
  const sources = ['stage/remote', 'page/clip', 'page/element', 'page/puff', 'three'].map(
    (folder) => `src/${folder}/warnings.ts`,
  );
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
  const text = textOf('dist/third-party-licenses.txt');
  // The page of films contains mediabunny.
  for (const name of ['three', 'rapier3d', 'glam', 'wasm-bindgen', 'mediabunny']) {
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
