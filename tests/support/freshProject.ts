/** Projects outside this repository that install the tarball of `npm run package`. */
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { expect, test as base, type Server } from './embed.ts';
import { script } from './server.ts';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const ELEMENT = '<cartoon-smoke preset="wisp" simulation-max-particles="300" style="height: 200px"></cartoon-smoke>';
export const PAGE = `<!doctype html><html lang="en"><meta charset="utf-8"><title>Waiting</title><link rel="icon" href="data:,">`;
export const PAGE_WITH_ELEMENT = PAGE + ELEMENT;
/** The strictest options; they also check the declarations of all packages. */
export const STRICT = {
  strict: true,
  exactOptionalPropertyTypes: true,
  noUncheckedIndexedAccess: true,
  skipLibCheck: false,
  target: 'es2023',
  lib: ['es2023', 'dom', 'dom.iterable'],
  types: [],
  noEmit: true,
};

/** Creates a project with these packages, cartoon-smoke and three.js, and returns its folder. */
export type MakeProject = (packages: readonly string[], files: Readonly<Record<string, string>>) => string;

export const test = base.extend<{ project: MakeProject }, { archive: string }>({
  archive: [
    async ({ server }, use) => {
      // Accessing the server builds the package.
      expect(server.address).toBeTruthy();
      const { ARCHIVE } = await script<{ ARCHIVE: string }>('setup/package.mjs');
      await use(join(ROOT, ARCHIVE));
    },
    { scope: 'worker', timeout: 300_000 },
  ],
  project: async ({ archive }, use) => {
    const place = mkdtempSync(join(tmpdir(), 'cartoon-smoke-project-'));
    await use((packages, files) => {
      write(place, { 'package.json': '{ "private": true, "type": "module" }', ...files });
      const three = packages.some((name) => name.startsWith('three@')) ? [] : ['three@0.187'];
      const all = [archive, ...three, ...packages];
      run(place, 'npm', ['install', '--no-audit', '--no-fund', ...all]);
      return place;
    });
    rmSync(place, { recursive: true });
  },
});

export { expect };

function write(place: string, files: Readonly<Record<string, string>>): void {
  for (const [file, text] of Object.entries(files)) {
    mkdirSync(dirname(join(place, file)), { recursive: true });
    writeFileSync(join(place, file), text);
  }
}

/** Runs a binary of a project's packages. On failure its output is the error message. */
export function bin(place: string, command: string, ...parameters: string[]): void {
  run(place, process.execPath, [join(place, 'node_modules', command), ...parameters]);
}

function run(place: string, program: string, parameters: readonly string[]): void {
  try {
    execFileSync(program, parameters, {
      cwd: place,
      stdio: 'pipe',
      encoding: 'utf8',
      // Vite's development server sets NODE_ENV in this process, and a later build would be one for development.
      env: { ...process.env, NODE_ENV: undefined, CI: '1' },
    });
  } catch (error) {
    const { stdout, stderr } = error as { stdout: string; stderr: string };
    throw new Error(`${program} ${parameters.join(' ')}\n${stdout}\n${stderr}`, { cause: error });
  }
}

/** Type-checks a project with both module resolutions of new projects. */
export function expectTypes(place: string, options: object, include: readonly string[]): void {
  for (const [module, moduleResolution] of [
    ['nodenext', 'nodenext'],
    ['esnext', 'bundler'],
  ]) {
    const compilerOptions = { ...STRICT, ...options, module, moduleResolution };
    write(place, { 'tsconfig.json': JSON.stringify({ compilerOptions, include }) });
    bin(place, 'typescript/bin/tsc', '-p', '.');
  }
}

/**
 * Serves the built project and waits until the page has this title. @param further additional checks while it is served
 */
export async function expectTitle(
  page: Page,
  place: string,
  title: string | RegExp,
  further: () => Promise<void> = async () => {},
): Promise<void> {
  const { serveSite } = await script<{ serveSite(folder: string, place: string): Promise<Server> }>('site/serve.mjs');
  const server = await serveSite(place, '/');
  await page.goto(server.address);
  await expect(page).toHaveTitle(title);
  await further();
  await server.close();
}
