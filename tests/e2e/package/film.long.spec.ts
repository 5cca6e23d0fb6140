/** The command `cartoon-smoke film` of the installed package, alone, by GNU parallel and by Slurm. */
import { execFileSync, spawn, type ChildProcess } from 'node:child_process';
import { randomBytes } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { hostname } from 'node:os';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { expect, test } from '../../support/freshProject.ts';
import { script } from '../../support/server.ts';

interface System {
  isDebianRoot(): boolean;
  aptGet(packages: string[], say: () => void): Promise<{ status: number; output: string }>;
}

const LINK = '#v=1&preset=lamp&simulation.maxParticles=300';
const FRAMES = 48;
/** The first of four shards has enough frames that it is killed before it ends. */
const FRAMES_OF_FIRST = FRAMES / 4;
const SHOT = ['--frames', `0-${FRAMES - 1}`, '--size', '320x180'];

/** Installs Debian packages, or skips the test where that is impossible. */
async function install(...packages: string[]): Promise<void> {
  const system = await script<System>('setup/browser.mjs');
  test.skip(!system.isDebianRoot(), 'Debian packages can only be installed by root on Debian');
  const { status, output } = await system.aptGet(packages, () => undefined);
  expect(status, output).toBe(0);
}

function run(place: string, program: string, ...parameters: string[]): string {
  return execFileSync(program, parameters, { cwd: place, encoding: 'utf8', stdio: 'pipe', env: environment(place) });
}

/** With Slurm's configuration in the project. */
function environment(place: string): NodeJS.ProcessEnv {
  return { ...process.env, SLURM_CONF: join(place, 'slurm/slurm.conf') };
}

function filesIn(folder: string): Record<string, string> {
  return Object.fromEntries(
    readdirSync(folder)
      .sort()
      .map((name) => [name, readFileSync(join(folder, name), 'base64')]),
  );
}

test('npx renders with an installed browser, and GNU parallel writes the same files', async ({ project }) => {
  await install('parallel');
  const place = project([], {});
  run(place, 'npx', 'cartoon-smoke', 'film', LINK, ...SHOT, '--out', 'one');
  const one = filesIn(join(place, 'one'));
  expect(Object.keys(one)).toHaveLength(2 * FRAMES);
  const words = ['npx', 'cartoon-smoke', 'film', `'${LINK}'`, ...SHOT, '--out', 'parts', '--shard', '{}/3'];
  run(place, 'parallel', '--will-cite', '--jobs', '2', '--halt', 'soon,fail=1', words.join(' '), ':::', '1', '2', '3');
  expect(filesIn(join(place, 'parts'))).toEqual(one);
});

test('Slurm runs an array of shards, one is killed and runs again, and the files are those of one run', async ({
  project,
}) => {
  await install('slurm-wlm', 'munge');
  const place = project([], {});
  run(place, 'npx', 'cartoon-smoke', 'film', LINK, ...SHOT, '--out', 'one');
  const daemons = await startSlurm(place);
  try {
    // As in docs/film.md.
    writeFileSync(
      join(place, 'film.sh'),
      `#!/bin/sh
#SBATCH --array=1-4 --cpus-per-task=1 --requeue
exec npx cartoon-smoke film '${LINK}' ${SHOT.join(' ')} --out shots --states states --states-every 6 \\
  --shard "$SLURM_ARRAY_TASK_ID/4"
`,
    );
    run(place, 'sbatch', 'film.sh');
    await until(() => framesOfFirst(place) > 0, 'a frame of the first shard');
    run(place, 'scancel', '--full', '--signal=KILL', '1_1');
    await until(() => !run(place, 'squeue', '--noheader', '--jobs=1_1', '--states=R').trim(), 'the end of task 1');
    expect(framesOfFirst(place)).toBeLessThan(FRAMES_OF_FIRST);
    run(place, 'scontrol', 'requeue', '1_1');
    // Slurm waits for two minutes before it starts the task again.
    await until(() => !run(place, 'squeue', '--noheader').trim(), 'the end of all tasks');
    expect(filesIn(join(place, 'shots'))).toEqual(filesIn(join(place, 'one')));
  } finally {
    for (const daemon of daemons.toReversed()) await stop(daemon);
  }
});

/** Number of finished frames of the first shard. Reads names only, because a running task renames its files. */
function framesOfFirst(place: string): number {
  const names = existsSync(join(place, 'shots')) ? readdirSync(join(place, 'shots')) : [];
  return names.filter((name) => Number(/^frame-(\d+)\.json$/.exec(name)?.[1]) < FRAMES_OF_FIRST).length;
}

async function until(isTrue: () => boolean, what: string): Promise<void> {
  for (const end = Date.now() + 400_000; Date.now() < end;) {
    if (isTrue()) return;
    await wait(100);
  }
  throw new Error(`Timed out while waiting for ${what}.`);
}

/** A controller and one node with two cores on this machine, with their own key and ports. */
async function startSlurm(place: string): Promise<ChildProcess[]> {
  const folder = join(place, 'slurm');
  const name = hostname().split('.')[0];
  for (const path of ['', 'state', 'spool']) mkdirSync(join(folder, path), { recursive: true, mode: 0o755 });
  writeFileSync(join(folder, 'key'), randomBytes(1024), { mode: 0o400 });
  writeFileSync(
    join(folder, 'slurm.conf'),
    `ClusterName=film
SlurmctldHost=${name}(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=${folder}/munge.socket
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
StateSaveLocation=${folder}/state
SlurmdSpoolDir=${folder}/spool
SlurmctldPidFile=${folder}/slurmctld.pid
SlurmdPidFile=${folder}/slurmd.pid
SlurmctldPort=26817
SlurmdPort=26818
MpiDefault=none
ReturnToService=2
NodeName=${name} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=film Nodes=ALL Default=YES MaxTime=INFINITE State=UP
`,
  );
  const at = (file: string) => join(folder, file);
  const munge = ['--socket', at('munge.socket'), '--key-file', at('key'), '--pid-file', at('munged.pid')];
  const daemons = [
    ['munged', '--foreground', '--force', ...munge, '--log-file', at('munged.log'), '--seed-file', at('seed')],
    ['slurmctld', '-D'],
    ['slurmd', '-D', '-N', name],
  ];
  const started: ChildProcess[] = [];
  for (const [program, ...parameters] of daemons) {
    started.push(spawn(`/usr/sbin/${program}`, parameters, { cwd: place, env: environment(place), stdio: 'ignore' }));
    await wait(3000);
  }
  await until(() => /idle/.test(run(place, 'sinfo', '--noheader')), 'the node');
  return started;
}

async function stop(daemon: ChildProcess): Promise<void> {
  if (daemon.exitCode !== null) return;
  const ended = new Promise((resolve) => daemon.once('close', resolve));
  daemon.kill();
  await ended;
}
