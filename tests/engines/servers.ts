/** Serves the source modules and the built site to all tests, and builds the site where it is not fresh. */
import { fileURLToPath } from 'node:url';
import { createServer } from 'vite';
import type { TestProject } from 'vitest/node';
import { serveBuiltSite } from '../support/builtSite.ts';
import { findFreePort, script } from '../support/server.ts';
import type { Engine } from './engines.ts';

declare module 'vitest' {
  interface TaskMeta {
    /** Shown to whoever runs `npm run test:engines`. */
    note?: string;
  }

  interface ProvidedContext {
    /** What the project's tests run in. */
    engine: Engine;
    /** All that there are. */
    engines: Engine[];
    /** Address of the source modules, on a development server; without a slash at the end. */
    sources: string;
    /** Address of the built site. */
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
