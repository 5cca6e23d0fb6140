import type { AddressInfo } from 'node:net';
import { fileURLToPath } from 'node:url';
import { preview } from 'vite';

const root = fileURLToPath(new URL('../..', import.meta.url));

export interface BuiltSite {
  /** Where it is served, without a slash at the end. */
  readonly address: string;
  stop(): Promise<void>;
}

/** Serves the site as it is published: a page loads some files, not hundreds. */
export async function serveBuiltSite(): Promise<BuiltSite> {
  // Port 0 is any that is free, also where several workers ask at once.
  const server = await preview({ root, logLevel: 'error', preview: { host: '127.0.0.1', port: 0 } });
  const { port } = server.httpServer.address() as AddressInfo;
  return { address: `http://localhost:${port}`, stop: () => server.close() };
}
