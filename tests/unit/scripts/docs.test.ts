/** The check of links that the build of the documentation runs on its pages. */
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, it } from 'vitest';
import { script } from '../../support/server.ts';

interface DocsScript {
  brokenLinks(folder: string): string[];
}

let folder: string;
let docs: DocsScript;
beforeEach(async () => {
  docs = await script<DocsScript>('site/docs.mjs');
  folder = mkdtempSync(join(tmpdir(), 'cartoon-smoke-docs-'));
  mkdirSync(join(folder, 'design'));
  writeFileSync(join(folder, 'index.html'), '<h2 id="size">Size</h2>');
  writeFileSync(join(folder, 'picture.png'), '');
});
afterEach(() => rmSync(folder, { recursive: true }));

it.each([
  ['a page', '<a href="../index.html">', false],
  ['a folder with a page', '<a href="../">', false],
  ['a heading', '<a href="../index.html#size">', false],
  ['a heading of the same page', '<h2 id="here"></h2><a href="#here">', false],
  ['a picture', '<img src="../picture.png">', false],
  ['a share link', '<a href="../index.html#v=1&amp;preset=lamp">', false],
  ['another host', '<a href="https://example.org/missing.html">', false],
  ['a missing page', '<a href="../missing.html">', true],
  ['a missing heading', '<a href="../index.html#colour">', true],
  ['a missing heading of the same page', '<a href="#there">', true],
  ['a missing picture', '<img src="picture.png">', true],
])('%s', (_, html, isBroken) => {
  writeFileSync(join(folder, 'design/page.html'), html);
  const [, target] = /(?:href|src)="([^"]*)"/.exec(html)!;
  expect(docs.brokenLinks(folder)).toEqual(isBroken ? [`design/page.html: ${target}`] : []);
});
