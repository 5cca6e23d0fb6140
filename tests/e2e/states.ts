/** Random states through the page: from the address to the stage, and from there back into the address. */
import type { Page } from '@playwright/test';
import fc from 'fast-check';
import { decode, encode } from '../../src/preset/codec.ts';
import { anyState } from '../support/anyState.ts';
import { expect } from '../support/fixtures.ts';
import { ask, open } from './page.ts';

/** @param seed of the random states, so that two tests may have others */
export async function expectStatesReturn(page: Page, count: number, seed: number): Promise<void> {
  await open(page, '?paused=1#v=1&preset=lamp&emission.rate=20&simulation.maxParticles=100');
  for (const { preset, values } of fc.sample(anyState, { numRuns: count, seed })) {
    // Rooms of their own take seconds to make anew, and another test has them.
    const state = { preset, values: { ...values, 'simulation.maxParticles': 100 } };
    // As somebody may type it: without the version, which the page writes in front.
    const typed = (await encode(state)).replace('#v=1&', '#');
    await page.evaluate((hash) => (location.hash = hash), typed);
    await expect.poll(() => ask(page, (stage) => stage.get())).toEqual(state.values);
    await expect.poll(() => page.evaluate(() => location.hash)).toMatch(/^#v=1&/);
    // Two deflaters may pack the same text otherwise, so what stands there is compared unpacked.
    expect(await decode(await page.evaluate(() => location.hash))).toEqual({ state, notices: [] });
  }
  await expect(page.locator('.notice')).toHaveCount(0);
}
