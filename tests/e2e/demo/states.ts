/** Random states through the page: from the address to the stage and back. */
import type { Page } from '@playwright/test';
import fc from 'fast-check';
import { decode, encode } from '../../../src/parameters/codec.ts';
import { anyState } from '../../support/anyState.ts';
import { expect } from '../../support/fixtures.ts';
import { ask, open } from './page.ts';

/** @param seed of the random states, so that tests use different ones */
export async function expectStatesReturn(page: Page, count: number, seed: number): Promise<void> {
  await open(page, '?paused=1#v=1&preset=lamp&emission.rate=20&simulation.maxParticles=100');
  for (const { preset, values } of fc.sample(anyState, { numRuns: count, seed })) {
    // Large buffers take seconds to allocate again, and another test covers them.
    const state = { preset, values: { ...values, 'simulation.maxParticles': 100 } };
    // As a user may type it: with the version at the end, which the page puts first.
    const typed = `${(await encode(state)).replace('#v=1&', '#')}&v=1`;
    await page.evaluate((hash) => (location.hash = hash), typed);
    await expect.poll(() => ask(page, (stage) => stage.get())).toEqual(state.values);
    await expect.poll(() => page.evaluate(() => location.hash)).toMatch(/^#v=1&/);
    // Two deflate implementations may pack the same text differently, so compare the unpacked state.
    expect(await decode(await page.evaluate(() => location.hash))).toEqual({ state, notices: [] });
  }
  await expect(page.locator('.notice')).toHaveCount(0);
}
