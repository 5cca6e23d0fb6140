/** The release workflow, as far as it runs without credentials: its own steps with its own commands. */
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, test } from 'vitest';
import { parse } from 'yaml';
import { Project } from '../../support/project.ts';
import { script } from '../../support/server.ts';

interface Workflow {
  jobs: Record<string, { steps: { name?: string; run?: string }[] }>;
}

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const BASE = 'https://example.org/some/where';
const { jobs } = parse(readFileSync(join(ROOT, '.github/workflows/release.yml'), 'utf8')) as Workflow;

const out = mkdtempSync(join(tmpdir(), 'cartoon-smoke-release-'));
afterAll(() => rmSync(out, { recursive: true }));

/** The command of a step; fails if the step is missing. */
function commandOf(job: string, name: string): string {
  const command = jobs[job].steps.find((step) => step.name === name)?.run;
  if (command === undefined) throw new Error(`The job ${job} has no step ${name}.`);
  return command;
}

describe('the tag', () => {
  const run = (changelog: string, tag: string) => {
    const project = new Project();
    project.write('CHANGELOG.md', changelog);
    project.write('package.json', JSON.stringify({ version: '1.2.3' }));
    const ending = project.run('release.mjs', [tag]);
    project.dispose();
    return ending;
  };

  test('matches the version, and the changelog has its entries', () => {
    expect(run('# Changelog\n\n## 1.2.3\n\n- Rings.\n', 'v1.2.3')).toMatchObject({ status: 0, errors: [] });
  });

  test('of another version is rejected', () => {
    expect(run('## 1.2.3\n\n- Rings.\n', 'v1.2.4').errors).toEqual([
      'The tag is v1.2.4, but package.json has version 1.2.3: tag v1.2.3, or change the version.',
    ]);
  });

  test.each(['## Unreleased\n\n- Rings.\n', '## 1.2.3\n\n## 1.2.2\n\n- Rings.\n', '## 1.2.30\n\n- Rings.\n'])(
    'without entries in the changelog is rejected: %j',
    (changelog) => {
      expect(run(changelog, 'v1.2.3')).toMatchObject({
        status: 1,
        errors: ['CHANGELOG.md has no entries for 1.2.3: rename the heading Unreleased to 1.2.3.'],
      });
    },
  );
});

describe('the site', () => {
  test('an invalid address is rejected by name before anything is built', () => {
    const project = new Project();
    const { status, errors } = project.run('build.mjs', [], { CARTOON_SMOKE_BASE: 'somewhere' });
    project.dispose();
    expect(status).toBe(1);
    expect(errors).toEqual([
      "CARTOON_SMOKE_BASE is somewhere: give the whole address of the site's folder, such as https://example.org/smoke/.",
    ]);
  });

  test('is built by the command of the workflow, with its public address', { timeout: 240_000 }, () => {
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
    expect(page).toMatch(/property="og:description" content="Cartoon smoke/);
    const picture = /property="og:image" content="(.*?)"/.exec(page)![1];
    expect(picture.startsWith(`${BASE}/`)).toBe(true);
    expect(existsSync(join(out, picture.slice(BASE.length)))).toBe(true);
    expect(readFileSync(join(out, 'oembed/lamp.json'), 'utf8')).toContain(`${BASE}/embed.html#v=1&amp;preset=lamp`);
    // Relative URLs only, so that it works in any folder.
    expect(page.match(/(?:src|href)="(?!\.\/|https:\/\/example\.org)[^"]*"/g)).toBe(null);
  });
});

describe('the package', () => {
  test('is accepted by npm with the command of the workflow', async () => {
    const { manifest } = await script<{ manifest: object }>('package/manifest.mjs');
    mkdirSync(join(out, 'package'));
    writeFileSync(join(out, 'package/package.json'), JSON.stringify(manifest));
    const command = `${commandOf('npm', 'Publish the package')} --dry-run --offline`;
    const { status, stdout } = spawnSync(command, { cwd: out, shell: true, encoding: 'utf8' });
    expect(status).toBe(0);
    const { name, version } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8')) as Record<string, string>;
    expect(stdout).toContain(`+ ${name}@${version}`);
  });
});
