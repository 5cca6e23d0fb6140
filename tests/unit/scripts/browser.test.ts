/** Launch flags of the browser for tests and benchmarks. */
import { chromium } from '@playwright/test';
import { expect, test } from 'vitest';
import { script } from '../../support/server.ts';

const featuresIn = (text: string) => /--disable-features=(\S+)/.exec(text)![1].split(',');

test('our browser flag disables every feature that the flag of Playwright disables', async () => {
  // The error of a failed launch contains the flags.
  const error = await chromium.launch({ executablePath: process.execPath }).then(() => '', String);
  const theirs = featuresIn(error);
  expect(theirs.length).toBeGreaterThan(0);
  const { CHROMIUM_FLAGS } = await script<{ CHROMIUM_FLAGS: string[] }>('setup/browser.mjs');
  expect(featuresIn(CHROMIUM_FLAGS.join(' '))).toEqual(expect.arrayContaining(theirs));
});
