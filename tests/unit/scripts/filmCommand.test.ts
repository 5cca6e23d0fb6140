/** Errors of `npm run film` before the first frame, and what it does about its browser. */
import { spawn, spawnSync, type ChildProcess } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism, hostname, tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
// @ts-expect-error -- a script without declarations
import * as cores from '../../../scripts/film/cores.mjs';
// @ts-expect-error -- a script without declarations
import * as profile from '../../../scripts/film/profile.mjs';

let folder: string;
beforeEach(() => (folder = mkdtempSync(join(tmpdir(), 'cartoon-smoke-film-'))));
afterEach(() => rmSync(folder, { recursive: true }));

/** The command without the set-up that `npm run film` begins with. */
const COMMAND = `
const { conclude } = await import('./scripts/lib/userError.mjs');
const { film } = await import('./scripts/film/film.mjs');
const [page, ...words] = process.argv.slice(1);
await conclude(() => film(words, { page, wasm: page }, '1'));`;

function command(words: string[], environment: NodeJS.ProcessEnv = {}) {
  const parameters = ['--input-type=module', '--eval', COMMAND, folder, ...words];
  const options = { encoding: 'utf8', env: { ...process.env, ...environment } } as const;
  const { status, stderr } = spawnSync(process.execPath, parameters, options);
  return { status, errors: stderr.trim() };
}

describe('one line and the status 1', () => {
  const shot = ['#v=1&preset=lamp', '--frames', '0-1'];

  it('for an unknown option', () => {
    const expected = "Unknown option '--bogus'. cartoon-smoke film --help lists the options.";
    expect(command([...shot, '--bogus', '--out', 'out'])).toEqual({ status: 1, errors: expected });
  });

  it('for what is not a link', () => {
    const { status, errors } = command(['lamp', '--frames', '0', '--out', 'out']);
    expect(status).toBe(1);
    expect(errors).toMatch(/^lamp is not a link: .*$/);
  });

  it.runIf(process.platform === 'linux')('for a folder that is read-only', () => {
    const { status, errors } = command([...shot, '--out', '/proc/frames']);
    expect(status).toBe(1);
    expect(errors).toMatch(/^\/proc\/frames cannot be written: ENOENT: .*$/);
  });

  it.runIf(process.platform === 'linux')('for a video in a folder that is read-only', () => {
    const { status, errors } = command([...shot, '--out', join(folder, 'out'), '--video', '/proc/film.webm']);
    expect(status).toBe(1);
    expect(errors).toMatch(/^\/proc cannot be written: ENOENT: .*$/);
  });

  it('without a browser, and leaves the folder empty', () => {
    const nowhere = { CHROMIUM_PATH: '', PLAYWRIGHT_BROWSERS_PATH: folder, HOME: folder, PATH: folder };
    const { status, errors } = command([...shot, '--out', join(folder, 'out')], nowhere);
    expect(status).toBe(1);
    expect(errors).toMatch(/^No browser was found: .*$/);
    expect(readdirSync(join(folder, 'out'))).toEqual([]);
  });
});

describe('the profile of the browser', () => {
  const createProfile = profile.createProfile as () => string;
  const name = (host: string, pid: number) => `cartoon-smoke-browser-${host}-${pid}-abc123`;
  beforeEach(() => vi.stubEnv('TMPDIR', folder));
  afterEach(() => vi.unstubAllEnvs());

  it.skipIf(process.platform === 'win32')(
    'is removed by a later run if its own was killed, on the same machine',
    () => {
      const { pid } = spawnSync('true');
      const others = [name('elsewhere', pid), name(hostname(), process.pid), 'other'];
      for (const each of [...others, name(hostname(), pid)]) mkdirSync(join(folder, each));
      expect(readdirSync(folder)).toHaveLength(4);
      const created = createProfile();
      expect(readdirSync(folder).map((each) => join(folder, each))).toEqual(
        [...others.map((each) => join(folder, each)), created].sort(),
      );
    },
  );
});

describe('cores', () => {
  const useOwnCores = cores.useOwnCores as (group: number) => void;
  const canPin = availableParallelism() > 1 && spawnSync('taskset', ['--version']).status === 0;
  const coresOf = (pid: number | string) =>
    /Cpus_allowed_list:.*/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))?.[0];
  const children: ChildProcess[] = [];
  const pinned = async (detached: boolean) => {
    const child = spawn('taskset', ['-c', '0', 'sleep', '60'], { detached });
    children.push(child);
    await vi.waitUntil(() => readFileSync(`/proc/${child.pid}/comm`, 'utf8').startsWith('sleep'));
    return Number(child.pid);
  };
  afterEach(() => children.splice(0).forEach((child) => child.kill()));

  it.runIf(canPin)('of a process group become those of this process', async () => {
    const [own, other] = [await pinned(true), await pinned(false)];
    expect(coresOf(own)).not.toBe(coresOf('self'));
    useOwnCores(own);
    expect(coresOf(own)).toBe(coresOf('self'));
    expect(coresOf(other)).not.toBe(coresOf('self'));
  });
});
