/** The site, built by the command of the release workflow. */
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, expect, test } from 'vitest';
import { commandOf, ROOT } from './workflow.ts';

const BASE = 'https://example.org/some/where';
const out = mkdtempSync(join(tmpdir(), 'cartoon-smoke-site-'));
afterAll(() => rmSync(out, { recursive: true }));

test('the site is built by the command of the workflow, with its public address', () => {
  const { status, stderr } = spawnSync(`${commandOf('build', 'Build the site')} -- --out "$OUT"`, {
    cwd: ROOT,
    shell: true,
    encoding: 'utf8',
    env: { ...process.env, CARTOON_SMOKE_BASE: BASE, OUT: out },
  });
  expect(status, stderr).toBe(0);
  const page = readFileSync(join(out, 'index.html'), 'utf8');
  expect(page).toContain(`<link rel="canonical" href="${BASE}/">`);
  expect(readFileSync(join(out, 'paper.html'), 'utf8')).toContain(`href="${BASE}/paper.html"`);
  for (const [file, path] of [
    ['index.html', ''],
    ['puff.html', 'puff.html'],
    ['design/puff.html', 'design/puff.html'],
  ]) {
    const document = readFileSync(join(out, 'docs', file), 'utf8');
    expect(document).toContain(`<link rel="canonical" href="${BASE}/docs/${path}">`);
  }
  expect(readFileSync(join(out, 'docs/404.html'), 'utf8')).not.toContain('rel="canonical"');
  expect(page).toMatch(/property="og:description" content="Cartoon smoke/);
  const picture = /property="og:image" content="(.*?)"/.exec(page)![1];
  expect(picture.startsWith(`${BASE}/`)).toBe(true);
  expect(existsSync(join(out, picture.slice(BASE.length)))).toBe(true);
  expect(readFileSync(join(out, 'oembed/lamp.json'), 'utf8')).toContain(`${BASE}/embed.html#v=1&amp;preset=lamp`);
  // Relative URLs only, so that it works in any folder.
  expect(page.match(/(?:src|href)="(?!\.\/|https:\/\/example\.org)[^"]*"/g)).toBe(null);
});
