/**
 * A static file server for a built site, as on a web host: it serves from any folder, with gzip, and records what it
 * sends.
 */

import { readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { join, normalize } from 'node:path';
import { gzipSync } from 'node:zlib';
import { lookup } from 'mrmime';

/**
 * @typedef {object} SiteServer
 * @property {string} address of the site's folder, with a trailing slash
 * @property {{ file: string, bytes: number }[]} sent the responses so far: bytes over the network, without headers
 * @property {() => Promise<void>} close
 */

/**
 * Serves `folder` at the path `place` of a separate origin.
 *
 * @param {string} folder
 * @param {string} place with a leading and a trailing slash
 * @param {Record<string, string>} [headers] of every response
 * @returns {Promise<SiteServer>}
 */
export async function serveSite(folder, place, headers = {}) {
  /** @type {SiteServer['sent']} */
  const sent = [];
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? '/', 'http://host').pathname);
    const file = path.endsWith('/') ? `${path}index.html` : path;
    const answer = file.startsWith(place) ? read(folder, file.slice(place.length)) : undefined;
    if (!answer) return response.writeHead(404).end();
    sent.push({ file: file.slice(place.length), bytes: answer.body.length });
    response.writeHead(200, { ...answer.headers, ...headers }).end(answer.body);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)));
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  const close = () => {
    server.closeAllConnections();
    return /** @type {Promise<void>} */ (new Promise((resolve) => server.close(() => resolve())));
  };
  return { address: `http://localhost:${port}${place}`, sent, close };
}

/** @type {Map<string, { time: number, body: Buffer }>} */
const packed = new Map();

/** @returns {{ body: Buffer, headers: Record<string, string> } | undefined} */
function read(/** @type {string} */ folder, /** @type {string} */ name) {
  const path = join(folder, normalize(`/${name}`));
  const status = statSync(path, { throwIfNoEntry: false });
  if (!status?.isFile()) return undefined;
  const known = packed.get(path);
  const body = known?.time === status.mtimeMs ? known.body : gzipSync(readFileSync(path), { level: 9 });
  packed.set(path, { time: status.mtimeMs, body });
  return {
    body,
    headers: {
      'content-type': lookup(path) ?? 'application/octet-stream',
      'content-encoding': 'gzip',
      'content-length': String(body.length),
      'cache-control': 'max-age=600',
    },
  };
}
