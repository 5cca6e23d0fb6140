/** One word for one thing: names that the code had once, or that no engineer would search for, do not come back. */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { basename, extname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseSync } from 'rolldown/utils';
import { describe, expect, it } from 'vitest';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const FOLDERS = ['src', 'shaders', 'scripts', 'tests', 'examples'];
/** Whether the Rust crates are held to the same words. */
const INCLUDES_RUST = true;
/** Built by wasm-bindgen; and this table. */
const SKIPPED = /^src\/sim\/wasm\/|^tests\/unit\/words\.test\.ts$/;
const TYPESCRIPT = ['.ts', '.tsx', '.mts', '.mjs'];
const GLSL_AND_RUST = ['.glsl', '.vert', '.frag', '.rs'];
/** Tests in Rust have sentences for names, which may say anything. */
const SENTENCE_WORDS = 4;

/** Old words, as parts of names, and what to say instead. */
const WORDS: readonly (readonly [old: RegExp, use: string])[] = [
  [/^quietly$/, 'ignoreRejection'],
  [/^wish(es)?$/, 'parsed attributes'],
  [/^patience$/, 'timeout or retry delay'],
  [/^knock(s|ed)?$/, 'handshake or connect'],
  [/^rivals?$/, 'comparison renderers'],
  [/^moods?$/, 'preset of a scene'],
  [/^bears?$/, 'spawn'],
  [/^stirr(er|ers|ing|ed)$/, 'vortex particles, vortexScale'],
  [/^passers?$/, 'swept particle'],
  [/^feel$/, 'particle coupling'],
  [/^backstage$/, 'debug panel'],
  [/^shelf$/, 'preset storage'],
  [/^(tells?|told)$/, 'notify, notification'],
  [/^strangers?$/, 'host or untrusted'],
  [/^(objections?|complaints?|refusals?|refuse[sd]?)$/, 'error, reject'],
  [/^sift(s|ed)?$/, 'cull'],
  [/^(lay|laid)$/, 'fill or write'],
  [/^stance$/, 'rotation'],
];

/** Old names as a whole. */
const NAMES: readonly (readonly [old: RegExp, use: string])[] = [
  [/^(most|least)[A-Z_]|^(MOST|LEAST)_/, 'max or min'],
  [/^kept[A-Z_]|^Kept/, 'memoized, cached, saved or retained'],
  [/^(Way|Spot|Place|Room|What)$/, 'a type is named by what it holds'],
  [/^Turn(s|ed|ing)?($|[A-Z])/, 'quaternion, rotation or angle'],
  [/^Eye$|^EyeUniforms$/, 'FrameView, ViewUniforms'],
  [/^longWay/, 'progressDelay'],
];

/** In TypeScript and GLSL no name for a rotation is a turn, not even as a part. */
const ROTATION = /^turn(s|ed|ing)?$/;
/** Two packed words of a row of the simulator. */
const PACKED = /^(src\/(sim|rows)|shaders|sim-wasm\/(bindings|reference|sim\/src\/(arrange|rows)))\b/;
const FOLDER_NAMES: Readonly<Record<string, string>> = {
  'src/host/': 'src/three',
  'src/frame/': 'src/iframe',
  'src/preset/moods/': 'src/preset/byScene',
};

/** What users write, what the WASM calls it, and what tests hand to Rust by name. */
const EXEMPT = new Set(['mostParticles', 'lookPointer', 'look_pointer', 'leastCap']);

/** The old words in a file, each with what to say instead. */
function oldWords(file: string, code: string): string[] {
  const stem = basename(file, extname(file));
  const names = [...stem.split('.'), ...namesIn(file, code)].filter((name) => !EXEMPT.has(name));
  const found = [...new Set(names)].flatMap((name) => {
    const instead = replacement(file, name);
    return instead ? [`${file}: ${name} -> ${instead}`] : [];
  });
  const folder = Object.keys(FOLDER_NAMES).find((old) => file.startsWith(old));
  return folder ? [`${file}: ${folder} -> ${FOLDER_NAMES[folder]}`, ...found] : found;
}

function replacement(file: string, name: string): string | undefined {
  const words = wordsOf(name);
  const isRust = file.endsWith('.rs');
  if (file.includes('/tests/') && isRust && words.length >= SENTENCE_WORDS) return undefined;
  if (!isRust && words.some((word) => ROTATION.test(word))) return 'quaternion, rotation or angle';
  if (PACKED.test(file) && words.includes('look')) return 'attributes';
  const byWord = WORDS.find(([old]) => words.some((word) => old.test(word)));
  return (byWord ?? NAMES.find(([old]) => old.test(name)))?.[1];
}

/** `maxParticles`, `MAX_PARTICLES` and `max_particles` are the same two words. */
function wordsOf(name: string): string[] {
  const parted = name.replace(/([a-z\d])([A-Z])/g, '$1 $2').replace(/([A-Z])([A-Z][a-z])/g, '$1 $2');
  return parted
    .toLowerCase()
    .split(/[^a-z]+/)
    .filter(Boolean);
}

function namesIn(file: string, code: string): string[] {
  if (TYPESCRIPT.includes(extname(file))) return identifiersOf(parseSync(file, code).program);
  if (!GLSL_AND_RUST.includes(extname(file))) return [];
  const bare = code.replace(/\/\/.*|\/\*[\s\S]*?\*\/|^\s*#include.*|"(?:\\.|[^"\\])*"/gm, ' ');
  return bare.match(/\b[A-Za-z_]\w*/g) ?? [];
}

function identifiersOf(node: unknown): string[] {
  if (Array.isArray(node)) return node.flatMap(identifiersOf);
  if (typeof node !== 'object' || node === null || !('type' in node)) return [];
  const own = /^(Private|JSX)?Identifier$/.test(String(node.type)) ? [(node as { name?: string }).name ?? ''] : [];
  return [...own, ...Object.values(node).flatMap(identifiersOf)];
}

const folders = INCLUDES_RUST ? [...FOLDERS, 'sim-wasm'] : FOLDERS;
const files = execFileSync('git', ['ls-files', '--cached', '--others', '--exclude-standard', ...folders], {
  cwd: ROOT,
  encoding: 'utf8',
})
  .split('\n')
  .filter((file) => [...TYPESCRIPT, ...GLSL_AND_RUST].includes(extname(file)) && !SKIPPED.test(file));

describe('old words', () => {
  it('are in no name of a file, a folder or an identifier', () => {
    expect(files.length).toBeGreaterThan(500);
    expect(files.flatMap((file) => oldWords(file, readFileSync(`${ROOT}/${file}`, 'utf8')))).toEqual([]);
  });

  it.each([
    ['src/a.ts', 'const isToldTwice = 1;', 'isToldTwice -> notify, notification'],
    ['src/a.ts', 'class A { #wish = { tellAll() {} }; }', 'wish -> parsed attributes'],
    ['src/a.tsx', 'const a = <b refusal={1} />;', 'refusal -> error, reject'],
    ['src/a.ts', 'const MOST_BYTES = 1;', 'MOST_BYTES -> max or min'],
    ['src/a.ts', 'type Way = 1;', 'Way -> a type is named by what it holds'],
    ['shaders/a.vert', 'in uvec2 look;', 'look -> attributes'],
    ['shaders/a.frag', 'vec2 turnOf(vec2 a);', 'turnOf -> quaternion, rotation or angle'],
    ['sim-wasm/a.rs', 'struct Stirrers;', 'Stirrers -> vortex particles, vortexScale'],
    ['src/host/a.ts', '', 'src/host/ -> src/three'],
    ['src/patience.ts', '', 'patience -> timeout or retry delay'],
  ])('are found in %s: %s', (file, code, message) => {
    expect(oldWords(file, code)).toContain(`${file}: ${message}`);
  });

  it.each([
    ['src/a.ts', "/** Told of a wish. */\nconst text = 'a rival' + `told`;"],
    ['src/a.ts', 'const most = Math.max(1, 2), kept = [];'],
    ['src/app/a.ts', 'const look = 1;'],
    ['shaders/a.frag', '// a look at a turn\nfloat phase;'],
    ['sim-wasm/sim/src/rigids/a.rs', 'fn look() {}'],
    ['sim-wasm/sim/tests/a.rs', 'fn a_take_of_another_surface_is_refused() { panic!("refusal"); }'],
  ])('are allowed in comments, texts and elsewhere: %s: %s', (file, code) => {
    expect(oldWords(file, code)).toEqual([]);
  });
});
