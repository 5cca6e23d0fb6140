/** Cost of a browser's processes: the renderer process, including its worker, and the GPU process. */

import { readFileSync } from 'node:fs';

const COUNTED = ['renderer', 'GPU'];

/**
 * @typedef {object} Cost
 * @property {number} seconds of CPU time so far
 * @property {number | undefined} megabytes of private memory; Linux only
 */

/** @param {import('@playwright/test').CDPSession} session with the browser @returns {Promise<Cost>} */
export async function costOf(session) {
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  const counted = processInfo.filter(({ type }) => COUNTED.includes(type));
  const memories = counted.map(({ id }) => memoryOf(id));
  return {
    seconds: counted.reduce((sum, { cpuTime }) => sum + cpuTime, 0),
    megabytes: memories.includes(undefined) ? undefined : memories.reduce((sum, each) => sum + each, 0),
  };
}

/**
 * @param {number} id of a process
 * @returns {any} megabytes of anonymous memory; undefined where unsupported
 */
function memoryOf(id) {
  try {
    return Number(/^RssAnon:\s+(\d+) kB/m.exec(readFileSync(`/proc/${id}/status`, 'utf8'))?.[1]) / 1000;
  } catch {
    return undefined;
  }
}
