/** Plain web hosts: for the built site from a folder deep inside, packed by gzip, under a strict policy, and for the package. */
import { fileURLToPath } from 'node:url';
import { script } from './server.ts';

export interface SiteServer {
  /** Of the folder, ending with a slash. */
  readonly address: string;
  /** What was answered so far: bytes over the wire, without headers. */
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

/** As hosts of static files do that let every page fetch them. */
export async function serveOpenly(folder: string): Promise<SiteServer> {
  const { serveSite } = await script<ServeScript>('site/serve.mjs');
  return serveSite(folder, PLACE, { 'access-control-allow-origin': '*' });
}

/** The whole repository, of which pages of other people load the package as npm has it. */
export async function serveRepository(): Promise<SiteServer> {
  const { serveSite } = await script<ServeScript>('site/serve.mjs');
  return serveSite(ROOT, '/');
}
