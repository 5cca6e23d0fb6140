import { expect } from '@playwright/test';
import type { Comparison } from './culling.cases.ts';

/**
 * Expects no pixel to differ between the pictures of any pair, although one draws fewer rows, and pictures with
 * content.
 */
export function expectSame(comparisons: readonly Comparison[]): void {
  for (const { changed, masked, shadowed, colors, bodies, casters } of comparisons) {
    expect([changed, masked]).toEqual([0, 0]);
    expect(shadowed).toBeGreaterThan(200);
    expect(colors).toBeGreaterThan(20);
    expect(bodies[0]).toBeLessThanOrEqual(bodies[1]);
    expect(casters[0]).toBeLessThanOrEqual(casters[1]);
  }
  // Thin smoke entirely inside a view may have nothing to cull.
  expect(comparisons.some(({ bodies }) => bodies[0] < bodies[1])).toBe(true);
  expect(comparisons.some(({ casters }) => casters[0] < casters[1])).toBe(true);
}

/** The same for dense smoke, which has hidden particles in every view. */
export function expectSameFromLess(comparisons: readonly Comparison[]): void {
  expectSame(comparisons);
  for (const { bodies, casters } of comparisons) {
    expect(bodies[0]).toBeLessThan(bodies[1]);
    expect(casters[0]).toBeLessThan(casters[1]);
  }
}
