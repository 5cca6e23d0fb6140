/** The copies of shared constants in the shaders and in Rust. With GENERATE set, the test writes them. */
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import * as constants from '../../src/base/constants.ts';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const SHARED: ReadonlyMap<string, readonly number[]> = new Map(
  Object.entries(constants).map(([name, value]: [string, number | readonly number[]]) => [name, [value].flat()]),
);

/** `const float NAME = 1.0;` of a shader and `const NAME: f32 = 1.0;` of Rust: type, name, type, value. */
const DECLARATION = /\bconst (?:(\w+) )?([A-Z][A-Z_]+)(?:: ([^=]+))? = ([^;]+);/g;
const NUMBER = /(?<![\w.])-?(?:0x[\da-f]+|\d[\d_]*\.?[\d_]*(?:e-?\d+)?)/g;

function filesOf(folder: string, kinds: RegExp): string[] {
  return readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' })
    .filter((file) => kinds.test(file) && !/(^|\/)target\//.test(file))
    .map((file) => `${folder}/${file}`);
}

const numbersIn = (text: string) => (text.match(NUMBER) ?? []).map((number) => Number(number.replaceAll('_', '')));

/** A number as both languages write it. */
function literal(value: number, isFloat: boolean): string {
  const text = String(value);
  return isFloat && /^-?\d+$/.test(text) ? `${text}.0` : text;
}

/** The text of a file with the shared values in its declarations, and the names of those constants. */
function withShared(text: string): { updated: string; names: string[] } {
  const names: string[] = [];
  const updated = text.replace(DECLARATION, (whole, type: string, name: string, rustType: string, value: string) => {
    const wanted = SHARED.get(name);
    if (!wanted) return whole;
    names.push(name);
    const found = numbersIn(value);
    expect(found, `the numbers of ${whole}`).toHaveLength(wanted.length);
    if (found.every((number, index) => number === wanted[index])) return whole;
    const isFloat = /f32|f64|float|vec/.test(type ?? rustType);
    const next = wanted.values();
    const written = value.replace(NUMBER, () => literal(next.next().value!, isFloat));
    return whole.replace(`= ${value};`, `= ${written};`);
  });
  return { updated, names };
}

it('has the shared constants in the shaders and in Rust', () => {
  const copied = new Set<string>();
  for (const file of [...filesOf('shaders', /\.\w+$/), ...filesOf('sim-wasm', /\.rs$/)]) {
    const text = readFileSync(join(ROOT, file), 'utf8');
    const { updated, names } = withShared(text);
    names.forEach((name) => copied.add(name));
    if (process.env.GENERATE) writeFileSync(join(ROOT, file), updated);
    else expect(text === updated, `${file} differs from src/base/constants.ts: run npm run generate`).toBe(true);
  }
  expect([...copied].sort(), 'constants that shaders or Rust copy').toEqual([...SHARED.keys()].sort());
});

it('has one definition of a shared constant in TypeScript', () => {
  for (const file of filesOf('src', /\.ts$/).filter((each) => each !== 'src/base/constants.ts')) {
    for (const [, , name] of readFileSync(join(ROOT, file), 'utf8').matchAll(DECLARATION))
      expect(SHARED.has(name), `${file} defines ${name} again`).toBe(false);
  }
});
