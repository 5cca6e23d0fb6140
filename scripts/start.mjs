/**
 * `npm start [-- --port N]`: sets up missing components and serves the demo page, reloading it when a source changes.
 */

import { conclude } from './lib/userError.mjs';
import { readArguments, readPort } from './lib/arguments.mjs';
import { requireFreePort, HOST } from './lib/port.mjs';
import { PAGE, setUp } from './setup/setup.mjs';
import { requireNode } from './setup/node.mjs';
import { root } from './lib/paths.mjs';

const COMMAND = 'npm start --';
const DEFAULT_PORT = 5173;

await conclude(async () => {
  const { values } = readArguments({ port: { type: 'string' } }, `${COMMAND} [--port N]`);
  const port = readPort(values.port, DEFAULT_PORT);
  requireNode();
  await requireFreePort(port, COMMAND);
  await setUp(PAGE);
  const { createServer } = await import('vite');
  const server = await createServer({ root, server: { host: HOST, port, strictPort: true } });
  await server.listen();
  console.log(`The page is served at http://localhost:${port}/ (stop with Ctrl+C).`);
});
