import { fileURLToPath } from 'node:url';
import { preview } from 'vite';
import { findFreePort, script } from './server.ts';

const root = fileURLToPath(new URL('../..', import.meta.url));

interface SiteScript {
  isFresh(): boolean;
  bring(say: (line: string) => void): Promise<void>;
}

export interface BuiltSite {
  /** Where it is served, without a slash at the end. */
  readonly address: string;
  stop(): Promise<void>;
}

/** Serves the site as it is published, built anew where sources have changed: a page loads some files, not hundreds. */
export async function serveBuiltSite(): Promise<BuiltSite> {
  const site = await script<SiteScript>('setup/site.mjs');
  if (!site.isFresh()) await site.bring(() => {});
  const port = await findFreePort();
  const server = await preview({ root, logLevel: 'error', preview: { host: '127.0.0.1', port, strictPort: true } });
  return { address: `http://localhost:${port}`, stop: () => server.close() };
}
