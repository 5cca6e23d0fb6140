import fc from 'fast-check';
import { expect } from 'vitest';
import { decode, encode } from '../../../src/parameters/codec.ts';
import { anyState } from '../../support/anyState.ts';

/** Writes random states to links and reads them back: each is unchanged and has no notices. */
export async function expectRoundTrips(count: number): Promise<void> {
  const returns = fc.asyncProperty(anyState, async (state) => {
    const hash = await encode(state);
    expect(await decode(hash)).toEqual({ state, notices: [] });
    expect(hash.length).toBeLessThanOrEqual(2000);
  });
  await fc.assert(returns, { numRuns: count });
}
