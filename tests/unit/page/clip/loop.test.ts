import { Matrix4, PerspectiveCamera, Vector3 } from 'three';
import { expect, test, vi } from 'vitest';
import { joined, stillOf } from '../../../../src/page/clip/loop.ts';
import { ATTRIBUTE_WORDS, NO_END, PLACE_FLOATS } from '../../../../src/simulator/layout.ts';
import type { Rows } from '../../../../src/simulator/rows.ts';
import type { View } from '../../../../src/simulator/view.ts';
import type { Arranger, FrameInput } from '../../../../src/renderer/frameInput.ts';
import { fetchExtras } from '../../../../src/renderer/extraPasses.ts';
import { styleOf } from '../../../../src/renderer/style.ts';
import { defaults } from '../../../../src/parameters/values.ts';

const SEEDS = [0, 100, 255];
const VIEW = { purpose: 'eye', cull: true, coverage: {} } as unknown as View;

/** A puff of radius 2 for each seed, at the same height, which moves by its own place. */
function smokeAt(height: number): Arranger & { asked: View[] } {
  const place = Float32Array.from(SEEDS.flatMap((_, at) => [at, height, 0, 2]));
  const attributes = Uint32Array.from(SEEDS.flatMap((seed) => [0x12345678, seed << 8, 5, 6]));
  const rows: Rows = { count: SEEDS.length, whole: SEEDS.length, place, attributes };
  const bounds = { min: [0, height, 0], max: [2, height, 0], greatestRadius: 2 } as const;
  const asked: View[] = [];
  const arrange = (view: View) => {
    asked.push(view);
    return { rows, bounds, grid: undefined };
  };
  return { asked, arrange, moves: vi.fn(() => Float32Array.from(SEEDS.flatMap((_, at) => [at, height, 0]))) };
}

const STYLE = styleOf(defaults());

function frameAt(height: number): FrameInput {
  const camera = new PerspectiveCamera();
  camera.position.set(0, height, 9);
  const light = { kind: 'sun', towards: new Vector3(0, 1, 0) } as const;
  const rigids = [new Matrix4().setPosition(height, 0, 0)];
  return { simulator: smokeAt(height), camera, light, rigids, blend: 1, style: STYLE } as unknown as FrameInput;
}

/** Radii of the remaining puffs, by height. */
function radii({ count, place }: Rows): Record<number, number[]> {
  const found: Record<number, number[]> = {};
  for (let row = 0; row < count; ++row) (found[place[4 * row + 1]] ??= []).push(place[4 * row + 3]);
  return found;
}

test('between two moments the old smoke dissolves puff by puff while the new smoke grows', () => {
  const still = stillOf(frameAt(5));
  const at = (share: number) => radii(joined(frameAt(1), still, share).simulator.arrange(VIEW).rows);
  expect(at(0)).toEqual({ 1: [2, 2, 2] });
  expect(at(1)).toEqual({ 5: [2, 2, 2] });
  const { 1: going, 5: coming } = at(0.5);
  expect(going).toHaveLength(2);
  expect(going[0]).toBeLessThan(going[1]);
  expect(coming).toHaveLength(2);
  expect(coming[0]).toBe(2);
});

test('nothing is culled and shadows do not end, because the occlusion changes', () => {
  const from = frameAt(1);
  const frame = joined(from, stillOf(frameAt(5)), 0.5);
  const { rows, bounds } = frame.simulator.arrange({ ...VIEW, purpose: 'light' });
  expect(rows.count).toBeGreaterThan(2);
  for (let row = 0; row < rows.count; ++row) {
    const [motion, kind, ...form] = rows.attributes.subarray(ATTRIBUTE_WORDS * row);
    expect(motion).toBe((NO_END | 0x5678) >>> 0);
    // The age of a caster: kept rows are those of an eye.
    expect(kind >>> 16).toBe(rows.place[PLACE_FLOATS * row + 1] === 5 ? 0x1234 : 0);
    expect(form.slice(0, 2)).toEqual([5, 6]);
  }
  const [view] = (from.simulator as ReturnType<typeof smokeAt>).asked;
  expect(view).toMatchObject({ cull: false, coverage: undefined });
  expect(bounds).toEqual({ min: [0, 1, 0], max: [2, 5, 0], greatestRadius: 2 });
});

test('camera and objects move from one moment to the other', () => {
  const still = stillOf(frameAt(5));
  const heights = [0, 0.5, 1].map((share) => {
    const { camera, rigids } = joined(frameAt(1), still, share);
    return [camera.position.y, rigids[0].elements[12]];
  });
  expect(heights).toEqual([
    [1, 1],
    [3, 3],
    [5, 5],
  ]);
});

test('displacements are those of the remaining puffs, and are only computed on request', () => {
  const from = frameAt(1);
  const { simulator } = joined(from, stillOf(frameAt(5)), 0.5);
  const { count, place } = simulator.arrange(VIEW).rows;
  expect(from.simulator.moves).not.toHaveBeenCalled();
  const moves = simulator.moves();
  expect(moves).toHaveLength(3 * count);
  for (let row = 0; row < count; ++row) {
    expect([...moves.subarray(3 * row, 3 * row + 3)]).toEqual([
      ...place.subarray(PLACE_FLOATS * row, PLACE_FLOATS * row + 3),
    ]);
  }
});

test('lamps at fire move and fade from one moment to the other', async () => {
  const style = styleOf({ ...defaults(), 'emission.glow': '0:1,1:1' });
  await fetchExtras(style);
  const frameWith = (...lamp: number[]): FrameInput => {
    const simulator = { ...smokeAt(1), glow: () => Float32Array.from(lamp) };
    return { ...frameAt(1), simulator, style };
  };
  const still = stillOf(frameWith(4, 2, 0, 1, 0, 0, 8, 3));
  const lampAt = (share: number) => {
    const { simulator } = joined(frameWith(0, 0, 0, 1, 8, 0, 0, 1), still, share);
    return [...simulator.glow!(1, new Float32Array())];
  };
  expect(lampAt(0)).toEqual([0, 0, 0, 1, 8, 0, 0, 1]);
  // Three quarters of the light are those of the second moment.
  expect(lampAt(0.5)).toEqual([3, 1.5, 0, 1, 4, 0, 4, 2]);
  expect(lampAt(1)).toEqual([4, 2, 0, 1, 0, 0, 8, 3]);
});
