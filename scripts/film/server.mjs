/** Serves the film page and answers it, on the loopback interface. src/demo/film/receiver.ts is the other side. */

import { randomBytes } from 'node:crypto';
import { createReadStream, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { dirname, extname, join, normalize } from 'node:path';
import { UserError } from '../lib/userError.mjs';

const TYPES = /** @type {Record<string, string>} */ ({ '.js': 'text/javascript', '.wasm': 'application/wasm' });
const PAGE = `<!doctype html><meta charset="utf-8"><title>Film</title><link rel="icon" href="data:,">
<script type="importmap">{ "imports": { "three": "./three/three.module.js" } }</script>
<script type="module" src="page.js"></script>`;

/**
 * @typedef {object} PageFiles
 * @property {string} page folder of the built page
 * @property {string} wasm folder of the simulator's variants
 *
 * @typedef {(request: { method: string, path: string, body: AsyncIterable<Uint8Array>, headers: import('node:http').IncomingHttpHeaders }) => Promise<Answer>} Answerer
 * @typedef {{ body?: string | Uint8Array | { file: string }, headers?: Record<string, string> } | undefined} Answer
 * undefined for an unknown path
 */

/**
 * @param {PageFiles} files
 * @param {Answerer} answer
 */
export async function servePage(files, answer) {
  const folders = { page: files.page, wasm: files.wasm, three: threeFolder() };
  // Pages that the user has open could otherwise call the server.
  const root = `/${randomBytes(16).toString('hex')}/`;
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost');
    if (!pathname.startsWith(root)) return response.writeHead(404).end();
    const path = decodeURIComponent(pathname.slice(root.length));
    const method = request.method ?? 'GET';
    const found = method === 'GET' ? fileAt(folders, path) : undefined;
    if (found) return response.writeHead(200, { 'content-type': found.type }).end(found.body);
    answer({ method, path, body: request, headers: request.headers }).then(
      (given) => send(response, given),
      () => response.writeHead(500).end(),
    );
  });
  // A frame of a large picture takes minutes.
  server.requestTimeout = 0;
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)));
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  return {
    address: `http://127.0.0.1:${port}${root}`,
    close() {
      server.closeAllConnections();
      server.close();
    },
  };
}

/**
 * @param {import('node:http').ServerResponse} response
 * @param {Answer} given
 */
function send(response, given) {
  if (!given) return response.writeHead(404).end();
  const { body, headers = {} } = given;
  response.writeHead(body === undefined ? 204 : 200, headers);
  if (body !== undefined && typeof body === 'object' && 'file' in body) {
    return createReadStream(body.file)
      .on('error', () => response.destroy())
      .pipe(response);
  }
  return response.end(body);
}

/**
 * @param {Record<string, string>} folders by the first part of a path; `page` has all others
 * @param {string} path
 */
function fileAt(folders, path) {
  if (path === '') return { type: 'text/html', body: PAGE };
  const type = TYPES[extname(path)];
  const name = normalize(path);
  if (!type || name.startsWith('..')) return undefined;
  const [first, ...rest] = name.split(/[/\\]/);
  const place = Object.hasOwn(folders, first) ? join(folders[first], ...rest) : join(folders.page, name);
  return statSync(place, { throwIfNoEntry: false })?.isFile() ? { type, body: readFileSync(place) } : undefined;
}

/** The built modules of three.js, a peer dependency of the package. @throws {UserError} if it is not installed */
function threeFolder() {
  try {
    return dirname(createRequire(import.meta.url).resolve('three'));
  } catch {
    throw new UserError('The command needs three.js. Install it beside cartoon-smoke: npm install three.');
  }
}
