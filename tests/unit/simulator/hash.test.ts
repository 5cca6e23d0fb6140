import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import {
  hashWithColliders,
  hashWithMeshes,
  hashWithoutRigids,
  hashWithRigids,
  linesOf,
} from '../../support/sim/hashFixture.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const fixture = readFileSync(new URL('../../../sim-wasm/sim/tests/collide_fixture.txt', import.meta.url), 'utf8');

describe('the hash of the same scenario in Node', () => {
  it.each(['core', 'meshes', 'physics'] as const)('is the native one without rigids in %s', async (variant) => {
    const hash = hashWithoutRigids(await loadVariant(variant), fixture);
    expect(hash).toBe(linesOf(fixture, 'hash without rigids')[0]);
  });

  it.each(['core', 'meshes', 'physics'] as const)('is the native one with colliders in %s', async (variant) => {
    expect(hashWithColliders(await loadVariant(variant), fixture)).toBe(linesOf(fixture, 'hash with colliders')[0]);
  });

  it.each(['meshes', 'physics'] as const)('is the native one with meshes in %s', async (variant) => {
    expect(hashWithMeshes(await loadVariant(variant), fixture)).toBe(linesOf(fixture, 'hash with meshes')[0]);
  });

  it('is the native one with rigids', async () => {
    expect(hashWithRigids(await loadVariant('physics'), fixture)).toBe(linesOf(fixture, 'hash with rigids')[0]);
  });
});
