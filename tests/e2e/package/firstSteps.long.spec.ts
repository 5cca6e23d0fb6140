/** `docs/first-steps.md`, followed word by word in an empty folder. */
import { execFileSync, spawn } from 'node:child_process';
import { copyFileSync, cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { expect, test } from '../../support/freshProject.ts';
import { pixelsOf } from '../../support/pictures.ts';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const MAX_STEPS = 8;
/** What lit smoke of all pages has. */
const SMOKE = '#fff4e3';

type Step = { command: string } | { file: string; text: string };

const [, ...sections] = readFileSync(join(ROOT, 'docs/first-steps.md'), 'utf8').split(/^## /m);
const stepsBy = new Map(sections.map((section) => [section.split('\n', 1)[0], stepsOf(section)]));
const PACKAGE = stepsBy.get('The package')!;
const PATHS = [...stepsBy].filter(([name, steps]) => steps.length > 0 && name !== 'The package');

/** Commands are blocks of `sh`. Files are other blocks, after the line that names them. */
function stepsOf(section: string): Step[] {
  const blocks = section.matchAll(/(?:Write `(\S+)`:\n\n)?^```(\w+)\n([^]*?)^```/gm);
  return [...blocks].flatMap(([, file, language, text]): Step[] => {
    if (language !== 'sh') return [{ file, text }];
    const commands = text.trim().split('\n');
    return commands.map((command) => ({ command }));
  });
}

test.use({ deviceScaleFactor: 1 });

test('each path has at most eight commands and edits', () => {
  expect(PATHS.map(([name]) => name)).toEqual([
    'A page',
    'One call',
    'A page with a bundler',
    'three.js',
    'React',
    'Vue',
    'Svelte',
  ]);
  for (const [name, steps] of PATHS) expect(PACKAGE.length + steps.length, name).toBeLessThanOrEqual(MAX_STEPS);
});

/** The folder in which the steps begin. */
let top: string;
test.beforeEach(() => (top = mkdtempSync(join(tmpdir(), 'cartoon-smoke-steps-'))));
test.afterEach(() => rmSync(top, { recursive: true }));

for (const [name, steps] of PATHS) {
  test(`${name}: the steps lead to smoke`, async ({ page, archive }) => {
    const clone = join(top, 'cartoon-smoke');
    // What the commands of the first section leave.
    mkdirSync(clone);
    copyFileSync(archive, join(clone, basename(archive)));
    cpSync(join(ROOT, 'examples'), join(clone, 'examples'), { recursive: true });
    let folder = top;
    for (const step of steps.slice(0, -1)) {
      if ('file' in step) writeFileSync(join(folder, step.file), step.text);
      else if (step.command.startsWith('cd ')) folder = join(folder, step.command.slice(3));
      else execFileSync('sh', ['-c', step.command], { cwd: folder, env: environment(), stdio: 'pipe' });
    }
    const { command } = steps.at(-1) as { command: string };
    await whileServing(command, folder, async (address) => {
      await page.goto(address);
      if (name === 'One call') await expectCall(page);
      else await expect.poll(() => pixelsOf(page, SMOKE)).toBeGreaterThan(150);
    });
  });
}

test('the first steps of the package are those of the repository and the tarball', ({ archive }) => {
  const { repository } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8')) as { repository: string };
  const [host, path] = repository.split(':');
  expect(PACKAGE).toEqual([
    { command: `git clone https://${host}.com/${path}` },
    { command: 'npm --prefix cartoon-smoke run package' },
  ]);
  const commands = PATHS.flatMap(([, steps]) => steps.flatMap((step) => ('command' in step ? step.command : [])));
  const installs = commands.filter((command) => command.includes(' install '));
  expect(installs).toHaveLength(PATHS.length);
  expect(installs.filter((command) => !command.endsWith(`cartoon-smoke/${basename(archive)}`))).toEqual([]);
});

/** Without questions of npm. Playwright's variables would reach the servers. */
function environment(): NodeJS.ProcessEnv {
  return {
    ...process.env,
    npm_config_yes: 'true',
    npm_config_audit: 'false',
    NODE_ENV: undefined,
    NO_COLOR: '1',
    FORCE_COLOR: undefined,
  };
}

/** Runs a command that serves a page until `use` is done. */
async function whileServing(command: string, folder: string, use: (address: string) => Promise<void>): Promise<void> {
  const server = spawn('sh', ['-c', `exec ${command}`], { cwd: folder, env: environment(), detached: true });
  try {
    const address = await new Promise<string>((resolve, reject) => {
      let said = '';
      const read = (data: Buffer) => {
        said += String(data);
        const [found] = /http:\/\/localhost:\d+/.exec(said) ?? [];
        if (found) resolve(found);
      };
      server.stdout.on('data', read);
      server.stderr.on('data', read);
      server.on('exit', () => reject(new Error(`${command} has ended:\n${said}`)));
    });
    await use(address);
  } finally {
    // With its children.
    process.kill(-server.pid!);
  }
}

async function expectCall(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'Vanish' }).click();
  await expect(page.getByRole('button')).toHaveCount(0);
}
