import { Box3, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { ShadowEnds } from '../../../src/smoke/shadowEnds.ts';
import { random } from '../../visual/random.ts';

const DOWN = new Vector3(0, -1, 0);
const NOWHERE = { bodies: new Float32Array(), reach: 1, boxes: [] };

function cloud(count: number, seed: number): Float32Array {
  const next = random(seed);
  return Float32Array.from({ length: 4 * count }, (_, index) => (index % 4 < 3 ? 4 * next() - 2 : 0.02 + 0.3 * next()));
}

function endsOf(casters: Float32Array, receivers: typeof NOWHERE | object, travel = DOWN): Float32Array {
  const count = casters.length / 4;
  const rows = { count, place: casters, attributes: new Uint32Array(2 * count) };
  return new ShadowEnds(count).find(rows, 1.1, { ...NOWHERE, ...receivers }, travel);
}

/** Whether a point is in the shadow of a ball, and its distance behind the centre. */
function inShadow(casters: Float32Array, row: number, point: Vector3, travel: Vector3): number | undefined {
  const offset = point.clone().sub(new Vector3().fromArray(casters, 4 * row));
  const along = offset.dot(travel);
  return offset.addScaledVector(travel, -along).length() < 1.1 * casters[4 * row + 3] ? along : undefined;
}

describe('shadows', () => {
  test('end behind every point of a puff or a box inside them', () => {
    const [casters, bodies] = [cloud(60, 1), cloud(80, 2)];
    const boxes = [new Box3(new Vector3(-1, -2.5, -2), new Vector3(0.5, -2.2, 1))];
    const next = random(3);
    for (const travel of [DOWN, new Vector3(0.7, -0.5, 0.4).normalize(), new Vector3(0, 0, 1)]) {
      const ends = endsOf(casters, { bodies, reach: 1.7, boxes }, travel);
      const points = Array.from({ length: 4000 }, (_, index) => {
        if (index % 2)
          return new Vector3(next(), next(), next()).multiply(boxes[0].getSize(new Vector3())).add(boxes[0].min);
        const way = new Vector3(next() - 0.5, next() - 0.5, next() - 0.5).normalize();
        const body = index % 80;
        return way.multiplyScalar(1.7 * bodies[4 * body + 3]).add(new Vector3().fromArray(bodies, 4 * body));
      });
      let held = 0;
      for (const point of points) {
        for (let row = 0; row < ends.length; row++) {
          const along = inShadow(casters, row, point, travel);
          if (along === undefined) continue;
          held++;
          expect(along).toBeLessThanOrEqual(ends[row] + 1e-5);
        }
      }
      expect(held).toBeGreaterThan(500);
    }
  });

  test('end before they start if nothing is behind the puff', () => {
    const casters = Float32Array.of(0, 1, 0, 0.2);
    expect(endsOf(casters, {})[0]).toBeLessThan(0);
    expect(endsOf(casters, { bodies: Float32Array.of(0, 3, 0, 0.2) })[0]).toBeLessThan(0);
    expect(endsOf(casters, { bodies: Float32Array.of(2, -1, 0, 0.2, 3, -1, 0, 0.2) })[0]).toBeLessThan(0);
    expect(endsOf(casters, { boxes: [new Box3(new Vector3(1, -1, -1), new Vector3(2, 0, 1))] })[0]).toBeLessThan(0);
  });

  test('end at the first point behind all receivers', () => {
    const casters = Float32Array.of(0, 1, 0, 0.2);
    expect(endsOf(casters, { bodies: Float32Array.of(0, -1, 0, 0.3, 2, -4, 0, 0.3) })[0]).toBeCloseTo(2.3);
    const table = new Box3(new Vector3(-2, -0.1, -2), new Vector3(2, 0, 2));
    // The bounding ball of the puff leaves it one radius later.
    expect(endsOf(casters, { boxes: [table] })[0]).toBeCloseTo(1.1 + 1.1 * 0.2);
  });
});
