/** A plain file server for a built site, as a web host is one: from any folder, packed by gzip, and it keeps count. */

import { readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { gzipSync } from 'node:zlib';

const TYPES = /** @type {Record<string, string>} */ ({
  '.css': 'text/css',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
});

/**
 * @typedef {object} SiteServer
 * @property {string} address of the site's folder, ending with a slash
 * @property {{ file: string, bytes: number }[]} sent what was answered so far: bytes over the wire, without headers
 * @property {() => Promise<void>} close
 */

/**
 * Serves `folder` from `place` of a host of its own.
 *
 * @param {string} folder
 * @param {string} place begins and ends with a slash
 * @param {Record<string, string>} [headers] of every answer
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
  const type = TYPES[extname(path)] ?? 'application/octet-stream';
  return {
    body,
    headers: {
      'content-type': type,
      'content-encoding': 'gzip',
      'content-length': String(body.length),
      'cache-control': 'max-age=600',
    },
  };
}
