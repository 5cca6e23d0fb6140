import { readFileSync, writeFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { keyOfAttribute, names } from '../../../../src/page/element/attributes/names.ts';
import type { StageMethods } from '../../../../src/page/element/methods.ts';
import type { Parameter } from '../../../../src/parameters/parameter.ts';
import { listNames } from '../../../../src/parameters/lists.ts';
import { table } from '../../../../src/parameters/table.ts';
import type { MethodName } from '../../../../src/stage/remote/calls.ts';
import { methodNames } from '../../../../src/stage/remote/methods.ts';

const METHODS = new URL('../../../../src/page/element/methods.json', import.meta.url);
/** Does not compile without each method that the element does itself. */
const OWN: Readonly<Record<Exclude<MethodName, keyof StageMethods>, true>> = {
  play: true,
  pause: true,
  resize: true,
  setBackground: true,
  setVisible: true,
};
const FILE = new URL('../../../../src/page/element/attributes/names.json', import.meta.url);

function isNumber(row: Parameter): boolean {
  return row.kind === 'number' || row.kind === 'integer' || typeof row.default === 'number';
}

/** The keys in the format of names.json: `$` marks texts, a vector is one key. */
function fieldsOf(rows: readonly Parameter[], prefix: string): string {
  const fields = rows.map((row) => row.key.slice(prefix.length) + (isNumber(row) ? '' : '$'));
  return fields.join(' ').replace(/(\S+\.)x \1y \1z(?= |$)/g, '$1xyz');
}

function expected(): string {
  const isListed = ({ key }: Parameter) => listNames.some((list) => key.startsWith(`${list}.`));
  const single = table.filter((row) => !isListed(row) || !/^\w+\.\d\./.test(row.key));
  const lists = listNames.map((list) => {
    const first = `${list}.0.`;
    return [
      list,
      fieldsOf(
        table.filter(({ key }) => key.startsWith(first)),
        first,
      ),
    ];
  });
  return `${JSON.stringify({ '': fieldsOf(single, ''), ...Object.fromEntries(lists) }, null, 2)}\n`;
}

it('lists the keys of the table (npm run generate writes them)', () => {
  if (process.env.GENERATE) writeFileSync(FILE, expected());
  else expect(readFileSync(FILE, 'utf8')).toBe(expected());
});

it('lists the methods of a stage that the element has unchanged (npm run generate writes them)', () => {
  const text = `${JSON.stringify(methodNames.filter((name) => !Object.hasOwn(OWN, name)).join(' '))}\n`;
  if (process.env.GENERATE) writeFileSync(METHODS, text);
  else expect(readFileSync(METHODS, 'utf8')).toBe(text);
});

it('has each parameter once, in the order of the table', () => {
  expect(names.map(({ key }) => key)).toEqual(table.map(({ key }) => key));
  expect(names.filter(({ isText }) => isText).map(({ key }) => key)).toEqual(
    table.filter((row) => !isNumber(row)).map(({ key }) => key),
  );
});

it('has unique attributes and properties', () => {
  expect(new Set(names.map(({ property }) => property)).size).toBe(names.length);
  expect(keyOfAttribute.size).toBe(names.length);
});

it('writes keys in kebab and camel case', () => {
  const named = (key: string) => names.find((name) => name.key === key);
  expect(named('emission.growthTime')).toMatchObject({
    attribute: 'emission-growth-time',
    property: 'emissionGrowthTime',
  });
  expect(named('forces.wind.x')).toMatchObject({ attribute: 'forces-wind-x', property: 'forcesWindX' });
  expect(named('vortices.0.coreRadius')).toMatchObject({
    attribute: 'vortices-0-core-radius',
    property: 'vortices0CoreRadius',
  });
});
