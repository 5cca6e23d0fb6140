/** `npm run preview [-- --port N]`: serves the built site; builds it first if it is missing or stale. */

import { readArguments, readPort } from './lib/arguments.mjs';
import { root } from './lib/paths.mjs';
import { requireFreePort, HOST } from './lib/port.mjs';
import { conclude } from './lib/userError.mjs';
import { requireNode } from './setup/node.mjs';
import { PAGE, setUp } from './setup/setup.mjs';
import * as site from './setup/site.mjs';

const COMMAND = 'npm run preview --';
const DEFAULT_PORT = 4173;

await conclude(async () => {
  const { values } = readArguments({ port: { type: 'string' } }, `${COMMAND} [--port N]`);
  const port = readPort(values.port, DEFAULT_PORT);
  requireNode();
  await requireFreePort(port, COMMAND);
  await setUp([...PAGE, site]);
  const { preview } = await import('vite');
  await preview({ root, preview: { host: HOST, port, strictPort: true } });
  console.log(`The built site is served at http://localhost:${port}/ (stop with Ctrl+C).`);
});
