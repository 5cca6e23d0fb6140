/** Checks whether a TCP port of this machine is available. */

import { createServer } from 'node:net';
import { UserError } from './userError.mjs';

/** The address that the project's servers listen on: the loopback interface, reached as `localhost`. */
export const HOST = '127.0.0.1';

/**
 * Throws if a port is in use.
 *
 * Checks both loopback addresses: a browser may resolve `localhost` to the other one and reach another server.
 *
 * @param {number} port
 * @param {string} command how to run the same command with another port
 */
export async function requireFreePort(port, command) {
  for (const address of [HOST, '::1']) {
    const code = await listenOnce(port, address);
    if (code === 'EADDRINUSE') {
      throw new UserError(
        `Port ${port} is in use: stop the program that uses it, or choose another with ${command} --port ${other(port)}.`,
      );
    }
    if (code === 'EACCES') {
      throw new UserError(
        `Port ${port} needs administrator rights: choose one above 1023 with ${command} --port 5173.`,
      );
    }
  }
}

/** Below the ephemeral ports, which the operating system assigns to connections and to servers without a fixed port. */
const [LOWEST, COUNT] = [20_000, 10_000];

/** A free port that the operating system does not assign to another process before it is used. */
export async function findFreePort() {
  for (;;) {
    const port = LOWEST + Math.floor(Math.random() * COUNT);
    const error = await listenOnce(port, HOST);
    if (error === '') return port;
    if (error !== 'EADDRINUSE') throw new UserError(`No port is available: ${error}.`);
  }
}

function listenOnce(/** @type {number} */ port, /** @type {string} */ address) {
  return new Promise((/** @type {(code: string) => void} */ resolve) => {
    const server = createServer();
    server.once('error', (/** @type {NodeJS.ErrnoException} */ error) => resolve(error.code ?? 'unknown'));
    server.listen(port, address, () => server.close(() => resolve('')));
  });
}

function other(/** @type {number} */ port) {
  return port < 65535 ? port + 1 : port - 1;
}
