/** Serves the source modules and the built site to all tests, and builds the site if it is out of date. */
import { fileURLToPath } from 'node:url';
import { createServer } from 'vite';
import type { TestProject } from 'vitest/node';
import { serveBuiltSite } from '../support/builtSite.ts';
import { findFreePort, script } from '../support/server.ts';
import type { Engine } from './engines.ts';

declare module 'vitest' {
  interface TaskMeta {
    /** Printed by `npm run test:engines`. */
    note?: string;
  }

  interface ProvidedContext {
    /** The engine of the tests' project. */
    engine: Engine;
    /** All engines. */
    engines: Engine[];
    /** URL of the source modules on a development server, without a trailing slash. */
    sources: string;
    /** URL of the built site. */
    site: string;
  }
}

interface Component {
  isFresh(): boolean;
  bring(say: () => void): Promise<void>;
}

export default async function serve(project: TestProject): Promise<() => Promise<void>> {
  const built = await script<Component>('setup/site.mjs');
  if (!built.isFresh()) await built.bring(() => undefined);
  const site = await serveBuiltSite();
  const port = await findFreePort();
  const configFile = fileURLToPath(new URL('../support/vite.config.ts', import.meta.url));
  const server = await createServer({ configFile, logLevel: 'error', server: { port, strictPort: true } });
  await server.listen();
  project.provide('sources', `http://localhost:${port}`);
  project.provide('site', site.address);
  return async () => {
    await server.close();
    await site.stop();
  };
}
