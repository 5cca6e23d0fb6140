/** Static file hosts: the built site in a nested folder, with gzip and a strict policy; and the package. */
import { fileURLToPath } from 'node:url';
import { script } from './server.ts';

export interface SiteServer {
  /** URL of the folder, with a trailing slash. */
  readonly address: string;
  /** Responses so far: size on the wire, without headers. */
  readonly sent: { file: string; bytes: number }[];
  close(): Promise<void>;
}

interface ServeScript {
  serveSite(folder: string, place: string, headers?: Record<string, string>): Promise<SiteServer>;
}

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const PLACE = '/some/where/';
const STRICT = {
  'content-security-policy':
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob: data:",
};

export async function serveStrictly(folder: string): Promise<SiteServer> {
  const { serveSite } = await script<ServeScript>('site/serve.mjs');
  return serveSite(folder, PLACE, STRICT);
}

/** With CORS for all origins, as hosts of static files have. */
export async function serveOpenly(folder: string): Promise<SiteServer> {
  const { serveSite } = await script<ServeScript>('site/serve.mjs');
  return serveSite(folder, PLACE, { 'access-control-allow-origin': '*' });
}

/** The whole repository. Host pages load the published package from it. */
export async function serveRepository(): Promise<SiteServer> {
  const { serveSite } = await script<ServeScript>('site/serve.mjs');
  return serveSite(ROOT, '/');
}
