/** Settings of the browser tests that all workers share: the port of the server and the browser. */

interface BrowserScript {
  findBrowser(): Promise<string | undefined>;
  findShell(): string | undefined;
  CHROMIUM_FLAGS: string[];
}

interface PortScript {
  findFreePort(): Promise<number>;
}

export interface TestServer {
  readonly port: number;
  /** Path of the Chromium to start, preferably a headless shell. */
  readonly browser: string;
  readonly flags: string[];
}

/**
 * Chooses a free port and a browser. Environment variables pass the choice to the workers, which load the configuration
 * again and need the same result.
 */
export async function requireTestServer(): Promise<TestServer> {
  const { findBrowser, findShell, CHROMIUM_FLAGS } = await script<BrowserScript>('setup/browser.mjs');
  process.env.TEST_PORT ||= String(await findFreePort());
  const browser = await findBrowser();
  if (!browser) throw new Error('There is no browser for the tests: npm test gets one.');
  process.env.TEST_BROWSER ||= process.env.CHROMIUM_PATH || findShell() || browser;
  process.env.CHROMIUM_PATH ||= browser;
  return { port: Number(process.env.TEST_PORT), browser: process.env.TEST_BROWSER, flags: CHROMIUM_FLAGS };
}

/** A free port outside the range for automatic assignment. */
export async function findFreePort(): Promise<number> {
  return (await script<PortScript>('lib/port.mjs')).findFreePort();
}

/** Imports a module of scripts/. These are plain JavaScript, so the caller gives the type. */
export function script<Module>(path: string): Promise<Module> {
  return import(new URL(`../../scripts/${path}`, import.meta.url).href) as Promise<Module>;
}
