/** A plain web host for tests of the built site: from a folder deep inside, packed by gzip, under a strict policy. */
import { script } from './server.ts';

export interface SiteServer {
  /** Of the site's folder, ending with a slash. */
  address: string;
  /** What was answered so far: bytes over the wire, without headers. */
  sent: { file: string; bytes: number }[];
  close(): Promise<void>;
}

interface ServeScript {
  serveSite(folder: string, place: string, headers?: Record<string, string>): Promise<SiteServer>;
}

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
