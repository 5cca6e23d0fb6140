/** The browsers of the tests, and how to start each of them. */
import { chromium, firefox, webkit } from '@playwright/test';
import { script } from '../support/server.ts';
import type { Driver } from './drivers/driver.ts';
import { startFirefox } from './drivers/firefox.ts';
import { startPlaywright } from './drivers/playwright.ts';
import { startWebKit } from './drivers/webkit.ts';

export interface Engine {
  readonly title: 'Chromium' | 'Firefox' | 'WebKit';
  /** Whether Playwright drives it. Debian's Firefox and WebKit, which render with llvmpipe, have separate drivers. */
  readonly isPlaywrights: boolean;
  /** Path of the browser; undefined if it is not installed. */
  readonly path: string | undefined;
}

interface FoundEngine {
  readonly isPlaywrights: boolean;
  readonly path: string;
}

interface BrowserScript {
  findBrowser(): Promise<string | undefined>;
  CHROMIUM_FLAGS: string[];
}

interface EnginesScript {
  ENGINES: readonly { title: 'Firefox' | 'WebKit'; find(): Promise<FoundEngine | undefined> }[];
}

const { findBrowser, CHROMIUM_FLAGS } = await script<BrowserScript>('setup/browser.mjs');

export async function findEngines(): Promise<Engine[]> {
  const { ENGINES } = await script<EnginesScript>('setup/engines.mjs');
  const engines: Engine[] = [{ title: 'Chromium', isPlaywrights: true, path: await findBrowser() }];
  for (const { title, find } of ENGINES) {
    engines.push({ title, isPlaywrights: false, path: undefined, ...(await find()) });
  }
  return engines;
}

/** @throws if the browser is not installed */
export async function start({ title, isPlaywrights, path }: Engine): Promise<Driver> {
  if (path === undefined) throw new Error(`There is no ${title} on this machine: npm run test:engines gets it.`);
  if (title === 'Chromium') return startPlaywright(chromium, { executablePath: path, args: CHROMIUM_FLAGS });
  if (isPlaywrights) return startPlaywright(title === 'Firefox' ? firefox : webkit, {});
  return title === 'Firefox' ? startFirefox(path) : startWebKit(path);
}
