import { readFileSync, writeFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { LIST_LIMIT, listNames } from '../../../src/parameters/lists.ts';
import { presets } from '../../../src/parameters/presets.ts';
import { table } from '../../../src/parameters/words/table.ts';
import type { Parameter } from '../../../src/parameters/words/words.ts';

const FILE = new URL('../../../src/parameters/valueTypes.ts', import.meta.url);

const literals = (values: readonly unknown[]) =>
  values.map((value) => (typeof value === 'string' ? `'${value}'` : String(value))).join(' | ');

function typeOf(row: Parameter): string {
  if (row.kind === 'choice') return literals(row.options.map(({ value }) => value));
  if (row.kind === 'toggle') return '0 | 1';
  return row.kind === 'number' || row.kind === 'integer' ? 'number' : 'string';
}

function fieldsOf(rows: readonly Parameter[], prefix: string): string[] {
  return rows.map((row) => {
    const key = row.key.slice(prefix.length);
    return `/** ${row.label}: ${row.text} */ ${/^\w+$/.test(key) ? key : `'${key}'`}: ${typeOf(row)};`;
  });
}

async function expected(): Promise<string> {
  const single = table.filter(({ key }) => !/^\w+\.\d\./.test(key));
  const fields = listNames.map((list) => {
    const first = `${list}.0.`;
    return fieldsOf(
      table.filter(({ key }) => key.startsWith(first)),
      first,
    );
  });
  const scoped = fields.filter((ofList) => ofList.some((field) => field.includes("'region.shape'")));
  const scope = scoped[0].filter((field) => scoped.every((ofList) => ofList.includes(field)));
  const lists = fields.map((ofList, index) => {
    const own = ofList.filter((field) => !scope.includes(field));
    return `${listNames[index]}: ${own.length < ofList.length ? 'ScopeValues & ' : ''}{\n${own.join('\n')}\n};`;
  });
  const { format } = await import('prettier');
  return format(
    `/** Types of presets and values, from the parameter table. \`npm run generate\` writes this file. */

/** The names of the presets. */
export type PresetName = ${literals(presets.map(({ name }) => name))};

/** The values of parameters that exist once, by their keys. */
export type SingleValues = {\n${fieldsOf(single, '').join('\n')}\n};

/** The index of an item of a list. */
export type ItemIndex = ${literals(Array.from({ length: LIST_LIMIT }, (_, index) => index))};

/** Where and when an item acts, by the ends of the keys. */
export type ScopeValues = {\n${scope.join('\n')}\n};

/** The values of an item of each list, by the ends of their keys: \`speed\` in \`emitters.0.speed\`. */
export type ListValues = {\n${lists.join('\n')}\n};

/** The values of all items of all lists, by their keys, such as \`emitters.0.speed\`. */
export type ItemValues = {
  [Key in {
    [List in keyof ListValues]: \`\${List}.\${ItemIndex}.\${keyof ListValues[List] & string}\`;
  }[keyof ListValues]]: Key extends \`\${infer List extends keyof ListValues}.\${ItemIndex}.\${infer Field}\`
    ? ListValues[List][Field & keyof ListValues[List]]
    : never;
};
`,
    { parser: 'typescript', printWidth: 120, singleQuote: true },
  );
}

it('are those of the table (npm run generate writes them)', async () => {
  const text = await expected();
  if (process.env.GENERATE) writeFileSync(FILE, text);
  else expect(readFileSync(FILE, 'utf8')).toBe(text);
});
