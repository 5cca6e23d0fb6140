import type { AddressInfo } from 'node:net';
import { fileURLToPath } from 'node:url';
import { preview } from 'vite';

const root = fileURLToPath(new URL('../..', import.meta.url));

export interface BuiltSite {
  /** URL without a trailing slash. */
  readonly address: string;
  stop(): Promise<void>;
}

/** Serves the built site: a page loads a few files instead of hundreds. */
export async function serveBuiltSite(): Promise<BuiltSite> {
  // Port 0 selects a free port, also for concurrent workers.
  const server = await preview({ root, logLevel: 'error', preview: { host: '127.0.0.1', port: 0 } });
  const { port } = server.httpServer.address() as AddressInfo;
  return { address: `http://localhost:${port}`, stop: () => server.close() };
}
