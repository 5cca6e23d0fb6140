/** The release workflow, as far as it runs without credentials: its own steps with its own commands. */
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, test } from 'vitest';
import { Project } from '../../support/project.ts';
import { script } from '../../support/server.ts';
import { commandOf, ROOT } from './workflow.ts';

const out = mkdtempSync(join(tmpdir(), 'cartoon-smoke-release-'));
afterAll(() => rmSync(out, { recursive: true }));

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
