/** Runs child processes. Their output is forwarded line by line, and they are killed when this process exits. */

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { createInterface } from 'node:readline';
import { stripVTControlCharacters } from 'node:util';
import { inRoot, root } from './paths.mjs';

/** @type {Set<import('node:child_process').ChildProcess>} */
const living = new Set();

process.on('exit', stopPrograms);
for (const signal of /** @type {const} */ (['SIGINT', 'SIGTERM', 'SIGHUP'])) {
  process.once(signal, () => {
    stopPrograms();
    process.exit(130);
  });
}

/** Ends all running child processes. */
export function stopPrograms() {
  for (const child of living) child.kill();
}

/**
 * @typedef {object} Outcome
 * @property {number} status the exit status; 127 when the program was not found, 128 when a signal ended it
 * @property {string} output of both streams, in order of arrival, without colours
 */

/**
 * Runs a program to its end. Never throws: a program that cannot be started has the status 127.
 *
 * @param {string} program
 * @param {readonly string[]} parameters
 * @param {object} [options]
 * @param {string} [options.folder] working directory. Default: the repository root
 * @param {NodeJS.ProcessEnv} [options.environment] added to the environment of this process
 * @param {(line: string) => void} [options.onLine] called with each line that is not empty
 * @param {number} [options.limit] timeout in milliseconds
 * @returns {Promise<Outcome>}
 */
export async function run(program, parameters, { folder = root, environment = {}, onLine, limit } = {}) {
  const child = spawn(program, parameters, {
    cwd: folder,
    env: { ...process.env, ...environment },
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  living.add(child);
  // Not the timeout option of spawn: it keeps waiting when the program was not found.
  const timer = limit === undefined ? undefined : setTimeout(() => child.kill(), limit);
  let output = '';
  for (const input of [child.stdout, child.stderr]) {
    createInterface({ input, crlfDelay: Infinity }).on('line', (line) => {
      // Some tools draw their progress with cursor movements.
      const plain = stripVTControlCharacters(line).trimEnd();
      if (!plain) return;
      output += `${plain}\n`;
      onLine?.(plain.trim());
    });
  }
  const [status] = await once(child, 'close').catch((error) => {
    output += `${error.message}\n`;
    return [127];
  });
  clearTimeout(timer);
  living.delete(child);
  return { status: status ?? 128, output: output.trimEnd() };
}

/**
 * Runs a script of the repository or of a package with this Node.
 *
 * @param {string} path relative to the repository root
 * @param {readonly string[]} parameters
 * @param {Parameters<typeof run>[2]} [options]
 */
export function runScript(path, parameters, options) {
  return run(process.execPath, [inRoot(path), ...parameters], options);
}
