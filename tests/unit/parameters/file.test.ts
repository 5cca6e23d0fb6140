import { readFileSync, writeFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { defaultState, type State } from '../../../src/parameters/codec.ts';
import { FileError } from '../../../src/base/errors.ts';
import { readFile, writeFile } from '../../../src/parameters/file.ts';
import { jsonFault } from '../../../src/parameters/jsonFault.ts';
import { fileSchema } from '../../../src/parameters/schema.ts';
import { table } from '../../../src/parameters/table.ts';
import { anyState } from '../../support/anyState.ts';

const SCHEMA = new URL('../../../public/smoke-file.schema.json', import.meta.url);
const head = '"format": "cartoon-smoke", "version": 1';
const codes = async (text: string) => (await readFile(text)).notices.map(({ code, key }) => `${code} ${key}`);

describe('a file', () => {
  it('restores every state and take, also above the particle limit of links', async () => {
    const bytes = fc.uint8Array({ maxLength: 300 });
    const anyModel = fc.record({ bytes, size: fc.double({ min: 0.01, max: 100, noNaN: true }) });
    const optional = { take: fc.option(bytes, { nil: undefined }), model: fc.option(anyModel, { nil: undefined }) };
    const anyFile = fc.record({ state: anyState, ...optional, seconds: fc.nat(1e6) });
    await fc.assert(
      fc.asyncProperty(anyFile, async ({ state, take, model: given, seconds }) => {
        const values = { ...state.values, 'simulation.maxParticles': 200_000 };
        const moment = take && { take: Uint8Array.from(take), seconds };
        const options = { size: given?.size, position: { x: 1, y: 0, z: -2 }, animation: 'Fly' };
        const model = given && { name: 'duck.glb', bytes: Uint8Array.from(given.bytes), options };
        const parts = { ...(moment && { moment }), ...(model && { model }) };
        const file = { name: 'Thunder', state: { ...state, values }, ...parts };
        expect(await readFile(await writeFile(file, './schema.json'))).toEqual({ ...file, notices: [] });
      }),
      { numRuns: 200 },
    );
  });

  it('is readable text', async () => {
    const state: State = { ...defaultState(), values: { ...defaultState().values, 'puff.size': 2, 'style.tones': 3 } };
    expect(await writeFile({ name: 'Big', state }, 'https://x/smoke-file.schema.json')).toBe(`{
  "$schema": "https://x/smoke-file.schema.json",
  "format": "cartoon-smoke",
  "version": 1,
  "name": "Big",
  "preset": "lamp",
  "values": {
    "puff.size": 2,
    "style.tones": 3
  }
}
`);
  });

  it('is read like a link: invalid values are reported and the rest applies', async () => {
    const values = '{"puff.size": 99, "emission.rate": "7", "bogus": 1, "__proto__": 1, "seed": [1], "take": "AAAA"}';
    const read = await readFile(`{${head}, "name": "  A\\u0007B ", "preset": "nowhere", "values": ${values}}`);
    expect(read.name).toBe('A B');
    expect(read.state.values).toMatchObject({ 'puff.size': 4, 'emission.rate': 7, seed: 1 });
    expect(read.notices.map(({ code, key }) => `${code} ${key}`).toSorted()).toEqual([
      'malformed seed',
      'outOfRange puff.size',
      'unknownKey __proto__',
      'unknownKey bogus',
      'unknownKey take',
      'unknownPreset preset',
    ]);
    expect(({} as Record<string, unknown>).bogus).toBeUndefined();
  });

  it('of a later version is read with a notice', async () => {
    expect(await codes(`{"format": "cartoon-smoke", "version": 7, "values": {}}`)).toEqual(['version v']);
  });

  it.each([
    ['', 'not valid JSON at line 1, column 1.'],
    ['{"format": "cartoon-smoke",\n  "version": 1,,\n}', 'not valid JSON at line 2, column 16.'],
    ['[]', 'The file must be an object, not an array'],
    ['{"asset": {"version": "2.0"}}', '"format" must be "cartoon-smoke"'],
    ['{"format": "cartoon-smoke", "values": {}}', '"version" must be a number, not undefined'],
    [`{${head}, "preset": 3}`, '"preset" must be a string, not a number'],
    [`{${head}, "values": [1]}`, '"values" must be an object, not an array'],
    [`{${head}, "moment": 3}`, '"moment" must be an object, not a number'],
    [`{${head}, "moment": {"take": "AAAA"}}`, '"seconds" of "moment" must be a number from 0, not undefined'],
    [`{${head}, "moment": {"seconds": 1}}`, '"take" of "moment" must be a string, not undefined'],
    [`{${head}, "moment": {"seconds": 1, "take": "A!"}}`, '"take" of "moment" is damaged'],
    [`{${head}, "model": "duck.glb"}`, '"model" must be an object, not a string'],
    [`{${head}, "model": {"name": "duck.glb"}}`, '"glb" of "model" must be a string, not undefined'],
    [`{${head}, "model": {"glb": "A!"}}`, '"glb" of "model" is damaged or too large'],
    [`{${head}, "model": {"glb": "AwA", "options": 3}}`, '"options" of "model" must be an object, not a number'],
  ])('that is invalid is rejected: %s', async (text, message) => {
    await expect(readFile(text)).rejects.toThrow(FileError);
    await expect(readFile(text)).rejects.toThrow(message);
  });
});

it('a model of 32 MB is read, a larger one is rejected', async () => {
  const sizes = [32 * 1024 * 1024, 32 * 1024 * 1024 + 1];
  const [text, larger] = await Promise.all(
    sizes.map((size) =>
      writeFile(
        { name: 'A', state: defaultState(), model: { name: 'a.glb', bytes: new Uint8Array(size), options: {} } },
        '',
      ),
    ),
  );
  expect((await readFile(text)).model!.bytes.length).toBe(sizes[0]);
  await expect(readFile(larger)).rejects.toThrow('"glb" of "model" is damaged or too large');
});

describe('the position of a fault', () => {
  it('is reported exactly for text that is not JSON', () => {
    const isJson = (text: string) => {
      try {
        JSON.parse(text);
        return true;
      } catch {
        return false;
      }
    };
    const fragments = fc.constantFrom(
      ...Array.from('{}[],:" \n\\'),
      'true',
      'nul',
      '1',
      '-',
      '.5',
      'e3',
      '"a"',
      '\u0007',
      '01',
    );
    const text = fc.oneof(
      fc.json(),
      fc.array(fragments, { maxLength: 12 }).map((parts) => parts.join('')),
    );
    fc.assert(
      fc.property(text, (candidate) => (jsonFault(candidate) === undefined) === isJson(candidate)),
      { numRuns: 3000 },
    );
  });

  it('of deep nesting is reported without a crash', () => {
    expect(jsonFault('['.repeat(100_000))).toEqual({ line: 1, column: 201 });
  });
});

describe('the schema', () => {
  it('equals the file in public/ (npm run generate writes it)', () => {
    const text = `${JSON.stringify(fileSchema(), null, 1)}\n`;
    if (process.env.GENERATE) writeFileSync(SCHEMA, text);
    else expect(readFileSync(SCHEMA, 'utf8')).toBe(text);
  });

  it('has every key of the table', () => {
    const { properties, patternProperties } = (fileSchema().properties as { values: Record<string, object> }).values;
    const patterns = Object.keys(patternProperties).map((pattern) => new RegExp(pattern));
    const unknown = table.filter(({ key }) => !(key in properties) && !patterns.some((pattern) => pattern.test(key)));
    expect(unknown).toEqual([]);
  });
});
