/** The temporary folder of a browser. Host and process are in its name, so that a later run can remove it. */

import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { hostname, tmpdir } from 'node:os';
import { join } from 'node:path';

/** Creates a folder, and removes those of killed runs on this machine. */
export function createProfile() {
  for (const name of readdirSync(tmpdir())) {
    const [, host, pid] = /^cartoon-smoke-browser-(.+)-(\d+)-\w{6}$/.exec(name) ?? [];
    if (host === hostname() && !isRunning(Number(pid))) removeProfile(join(tmpdir(), name));
  }
  return mkdtempSync(join(tmpdir(), `cartoon-smoke-browser-${hostname()}-${process.pid}-`));
}

export function removeProfile(/** @type {string} */ folder) {
  try {
    rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
  } catch {
    // It belongs to another user.
  }
}

function isRunning(/** @type {number} */ pid) {
  try {
    return process.kill(pid, 0);
  } catch (error) {
    // A process of another user cannot be signalled.
    return /** @type {NodeJS.ErrnoException} */ (error).code === 'EPERM';
  }
}
