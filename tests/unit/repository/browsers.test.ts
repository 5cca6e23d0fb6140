/** One list of browsers, in package.json, drives the bundlers, the linter, the README and the message. */
import { readFileSync } from 'node:fs';
import { parse } from 'acorn';
import { expect, test } from 'vitest';

const read = (path: string) => readFileSync(path, 'utf8');
const { browserslist } = JSON.parse(read('package.json')) as { browserslist: string[] };
const versionOf = (name: string) => browserslist.find((each) => each.startsWith(`${name} `))!.split('>= ')[1];
const PAGES = ['index', 'paper', 'puff', 'examples', 'embed', 'overlay'];

test('the README and the message name the versions of the list', () => {
  expect(versionOf('edge')).toBe(versionOf('chrome'));
  expect(versionOf('ios_saf')).toBe(versionOf('safari'));
  const names = [`Edge ${versionOf('chrome')}`, `Firefox ${versionOf('firefox')}`, `Safari ${versionOf('safari')}`];
  for (const file of ['README.md', 'public/check.js'])
    for (const name of names) expect(read(file), file).toContain(name);
});

test('the bundlers and the linter follow the list', () => {
  expect(read('vite.config.ts')).toContain('target: browserslistToEsbuild()');
  expect(read('scripts/package/bundle.mjs')).toContain('target: browserslistToEsbuild()');
  expect(read('.oxlintrc.json')).toContain('"compat/compat": "error"');
});

test.each(PAGES)('%s.html runs the check, which is ECMAScript 5, before its module', (page) => {
  expect(read(`${page}.html`)).toMatch(/<script defer src="\.\/check\.js"><\/script>\s*<script type="module"/);
  parse(read('public/check.js'), { ecmaVersion: 5 });
});
