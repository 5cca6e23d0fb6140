/** The cores that the browser draws on. */

import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';

/**
 * Lets all threads of a process group use the cores of this process, on Linux. SwiftShader pins its threads to the first
 * cores, whatever cores it was given: of two runs under `taskset -c 0` and `taskset -c 1`, both would draw on core 0.
 *
 * @param {number} group
 */
export function useOwnCores(group) {
  if (process.platform !== 'linux') return;
  const own = coresOf('/proc/self');
  for (const pid of readdirSync('/proc').filter((name) => /^\d+$/.test(name))) {
    try {
      // The fields after the name of the program: state, parent, group.
      if (Number(readFileSync(`/proc/${pid}/stat`, 'utf8').split(') ').at(-1)?.split(' ')[2]) !== group) continue;
      const tasks = `/proc/${pid}/task`;
      const isPinned = readdirSync(tasks).some((task) => coresOf(`${tasks}/${task}`) !== own);
      if (isPinned) spawnSync('taskset', ['-a', '-c', '-p', own, pid]);
    } catch {
      // The process has ended.
    }
  }
}

/** Such as 0-1. */
function coresOf(/** @type {string} */ folder) {
  return /^Cpus_allowed_list:\s*(\S+)/m.exec(readFileSync(`${folder}/status`, 'utf8'))?.[1] ?? '';
}
