import { Box3, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { createShadowEnds } from '../../../src/renderer/shadowEnds.ts';
import { random } from '../../visual/random.ts';

const DOWN = new Vector3(0, -1, 0);
const NOWHERE = { bodies: new Float32Array(), reach: 1, boxes: [] };

function cloud(count: number, seed: number): Float32Array {
  const next = random(seed);
  return Float32Array.from({ length: 4 * count }, (_, index) => (index % 4 < 3 ? 4 * next() - 2 : 0.02 + 0.3 * next()));
}

function endsOf(
  casters: Float32Array,
  receivers: typeof NOWHERE | object,
  travel = DOWN,
  lamp?: Vector3,
): Float32Array {
  const count = casters.length / 4;
  const rows = { count, whole: count, place: casters, attributes: new Uint32Array(2 * count) };
  return createShadowEnds(count)(rows, 1.1, { ...NOWHERE, ...receivers }, travel, lamp);
}

/** Whether a point is in the shadow of a ball, and its distance behind the centre, along the light at the centre. */
function inShadow(
  casters: Float32Array,
  row: number,
  point: Vector3,
  sun: Vector3,
  lamp?: Vector3,
): number | undefined {
  const centre = new Vector3().fromArray(casters, 4 * row);
  const ball = 1.1 * casters[4 * row + 3];
  const travel = lamp ? centre.clone().sub(lamp).normalize() : sun;
  const distance = lamp ? Math.max(lamp.distanceTo(centre), 1.2 * ball) : Infinity;
  const offset = point.clone().sub(centre);
  const along = offset.dot(travel);
  const radius = (ball / Math.sqrt(1 - (ball / distance) ** 2)) * (1 + along / distance);
  return along > 0 && offset.addScaledVector(travel, -along).length() < radius ? along : undefined;
}

describe('shadows', () => {
  test('end behind every point of a puff or a box inside them', () => {
    const [casters, bodies] = [cloud(60, 1), cloud(80, 2)];
    const boxes = [new Box3(new Vector3(-1, -2.5, -2), new Vector3(0.5, -2.2, 1))];
    const next = random(3);
    const lamps = [new Vector3(1, 4, -2), new Vector3(9, 1, 3), new Vector3(0.5, 0.2, 0.1)];
    const travels = [DOWN, new Vector3(0.7, -0.5, 0.4).normalize(), new Vector3(0, 0, 1), ...lamps];
    for (const from of travels) {
      const lamp = lamps.includes(from) ? from : undefined;
      const travel = lamp ? from.clone().normalize().negate() : from;
      const ends = endsOf(casters, { bodies, reach: 1.7, boxes }, travel, lamp);
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
          const along = inShadow(casters, row, point, travel, lamp);
          if (along === undefined) continue;
          held++;
          if (along > ends[row] + 1e-5) expect.fail(`${along} of shadow ${row} is behind its end, ${ends[row]}`);
        }
      }
      expect(held).toBeGreaterThan(300);
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
    // The same under a lamp, but for the growth of the shadow on the way.
    const lamp = new Vector3(0, 5, 0);
    const behind = Float32Array.of(0, -1, 0, 0.3, 2, -4, 0, 0.3);
    expect(endsOf(casters, { bodies: behind }, DOWN, lamp)[0]).toBeCloseTo(2.3);
    expect(endsOf(casters, { boxes: [table] }, DOWN, lamp)[0]).toBeCloseTo((1.1 + 1.1 * 0.2) / (1 - 0.22 / 4), 2);
  });
});
