import { expect } from '@playwright/test';
import type { Comparison } from './cases/culling.ts';

/** That no pixel of any pair of pictures differs, though one of each was drawn from less, and that they show something. */
export function expectSame(comparisons: readonly Comparison[]): void {
  for (const { changed, masked, shadowed, colors, bodies, casters } of comparisons) {
    expect([changed, masked]).toEqual([0, 0]);
    expect(shadowed).toBeGreaterThan(200);
    expect(colors).toBeGreaterThan(20);
    expect(bodies[0]).toBeLessThan(bodies[1]);
    expect(casters[0]).toBeLessThan(casters[1]);
  }
}
