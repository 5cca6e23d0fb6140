import { Object3D, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { capsule, worldBall } from '../../../src/three/proxies.ts';

const LIMB = { from: new Vector3(0, 0, 0), to: new Vector3(0, 2, 0), radius: 0.3 };

/** Distance of the balls' outline from the capsule's axis at a height. */
function outlineAt(height: number): number {
  const reaches = capsule({ follows: new Object3D(), ...LIMB }).map(({ center, radius }) =>
    Math.sqrt(Math.max(0, radius ** 2 - (height - center!.y) ** 2)),
  );
  return Math.max(...reaches);
}

test('the balls of a capsule nearly fill it and do not extend beyond it', () => {
  for (let height = 0; height <= 2; height += 0.01) {
    expect(outlineAt(height)).toBeGreaterThan(0.96 * LIMB.radius);
    expect(outlineAt(height)).toBeLessThanOrEqual(LIMB.radius);
  }
  expect(outlineAt(2.31)).toBe(0);
});

test('a capsule follows its object, with the scale of the object', () => {
  const bone = new Object3D();
  bone.position.set(1, 0, 0);
  bone.scale.setScalar(2);
  bone.updateMatrixWorld();
  const last = worldBall(capsule({ follows: bone, ...LIMB }).at(-1)!)();
  expect(last.center.toArray()).toEqual([1, 4, 0]);
  expect(last.radius).toBeCloseTo(0.6, 9);
});

test('a capsule without length is a ball, and one without radius is rejected by name', () => {
  const follows = new Object3D();
  expect(capsule({ follows, ...LIMB, to: LIMB.from })).toHaveLength(1);
  expect(() => capsule({ follows, ...LIMB, radius: 0 })).toThrow(/capsule\.radius.*0/);
});
