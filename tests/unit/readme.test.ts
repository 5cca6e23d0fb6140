import { readFileSync, writeFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { attributes, cssParts, cssProperties, events, slots } from '../../src/element/documentation.ts';
import type { Parameter } from '../../src/preset/parameter.ts';
import { table } from '../../src/preset/table.ts';

const README = new URL('../../README.md', import.meta.url);

function range(parameter: Parameter): string {
  switch (parameter.kind) {
    case 'toggle':
      return '0, 1';
    case 'color':
      return 'colour';
    case 'curve':
      return 'curve';
    case 'ramp':
      return 'ramp';
    case 'choice':
      return parameter.options.map(({ value }) => value).join(', ');
    default:
      return `${parameter.min} to ${parameter.max} ${parameter.unit}`.trim();
  }
}

/** Where, when and on what an item acts: every list of forces has these, emitters all but the region. */
const SCOPE = /^\w+\.0\.(region\.|envelope\.|rigid$)/;

/** The items of a list are alike, and a vector's three numbers too, and what all lists have: one row stands for all. */
function rows(): string[] {
  const listed = table.filter(({ key }) => !/^\w+\.[1-7]\./.test(key) && !/^\w+\.0\..*\.[yz]$/.test(key));
  const scope = listed.filter(({ key }) => SCOPE.test(key) && key.startsWith('winds.'));
  return [
    ...listed.filter(({ key }) => !SCOPE.test(key)).map((parameter) => row(parameter, parameter.key)),
    ...scope.map((parameter) => row(parameter, parameter.key.replace('winds.', '*.'))),
  ];
}

function row(parameter: Parameter, key: string): string {
  const name = key.replace('.0.', '.0‥7.').replace(/(?<=\.0‥7\..*)\.x$/, '.x, .y, .z');
  return `| \`${name}\` | ${range(parameter)} | ${parameter.default} | ${parameter.text} |`;
}

/** What the element has besides the parameters. */
function elementRows(): string[] {
  const kinds = [
    ['attribute', attributes],
    ['event', events],
    ['slot', slots],
    ['part', cssParts],
    ['CSS property', cssProperties],
  ] as const;
  return kinds.flatMap(([kind, list]) =>
    list.map((each) => {
      const initial = 'default' in each && each.default ? ` (${each.default})` : '';
      return `| ${kind} | ${each.name ? `\`${each.name}\`` : 'without a name'} | ${each.description}${initial} |`;
    }),
  );
}

const TABLES = [
  ['parameters', ['| key | range | default | what it does |', '| --- | --- | --- | --- |', ...rows()]],
  ['element', ['| | name | what it is |', '| --- | --- | --- |', ...elementRows()]],
] as const;

it.each(TABLES)('lists the %s as they are (UPDATE_README=1 writes them anew)', (name, lines) => {
  const text = readFileSync(README, 'utf8');
  const block = new RegExp(`(<!-- ${name} -->\n)[^]*(<!-- /${name} -->)`);
  const updated = text.replace(
    block,
    (_, before: string, after: string) => `${before}\n${lines.join('\n')}\n\n${after}`,
  );
  expect(text).toMatch(block);
  if (process.env.UPDATE_README) writeFileSync(README, updated);
  else expect(text).toBe(updated);
});
