/** What the browser tests run against: the port of their server and the browser, the same in every worker. */

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
  /** Path of the Chromium to start; one without windows where there is one. */
  readonly browser: string;
  readonly flags: string[];
}

/**
 * Chooses a free port and a browser. The choice is left in the environment, which the workers inherit: they load the
 * configuration again and have to come to the same result.
 */
export async function demandTestServer(): Promise<TestServer> {
  const { findBrowser, findShell, CHROMIUM_FLAGS } = await script<BrowserScript>('setup/browser.mjs');
  process.env.TEST_PORT ||= String(await findFreePort());
  const browser = await findBrowser();
  if (!browser) throw new Error('There is no browser for the tests: npm test gets one.');
  process.env.TEST_BROWSER ||= process.env.CHROMIUM_PATH || findShell() || browser;
  process.env.CHROMIUM_PATH ||= browser;
  return { port: Number(process.env.TEST_PORT), browser: process.env.TEST_BROWSER, flags: CHROMIUM_FLAGS };
}

/** A port that nobody listens on, nor is given to whoever asks for any. */
export async function findFreePort(): Promise<number> {
  return (await script<PortScript>('lib/port.mjs')).findFreePort();
}

/** Imports a module of scripts/, which is plain JavaScript and therefore has its type said here. */
export function script<Module>(path: string): Promise<Module> {
  return import(new URL(`../../scripts/${path}`, import.meta.url).href) as Promise<Module>;
}
