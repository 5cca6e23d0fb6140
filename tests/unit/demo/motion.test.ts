/** Motion vectors of flipbooks, against the projection of moving puffs. */
import { PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { drawMotion, MOTION_RANGE } from '../../../src/demo/capture/flipbook.ts';
import { joined, stillOf } from '../../../src/page/clip/loop.ts';
import type { Rows } from '../../../src/simulator/rows.ts';
import type { View } from '../../../src/simulator/view.ts';
import type { Arranger, FrameInput } from '../../../src/renderer/frameInput.ts';
import { styleOf } from '../../../src/renderer/style.ts';
import { defaults } from '../../../src/parameters/values.ts';

interface Puff {
  readonly from: readonly [number, number, number];
  /** Movement in a step. */
  readonly move: readonly [number, number, number];
  readonly radius: number;
  readonly seed: number;
}

const [WIDTH, HEIGHT, RATE] = [80, 60, 30];
const STEPS = 60 / RATE;

/** Interpolates like the simulator, and sorts from left to right so that the order changes with time. */
function smokeOf(puffs: readonly Puff[]): Arranger {
  let moves = new Float32Array();
  const arrange = ({ blend }: View) => {
    const placed = puffs.map((puff) => ({ ...puff, at: puff.from.map((x, axis) => x + blend * puff.move[axis]) }));
    placed.sort((a, b) => a.at[0] - b.at[0]);
    const place = Float32Array.from(placed.flatMap(({ at, radius }) => [...at, radius]));
    const attributes = Uint32Array.from(placed.flatMap(({ seed }) => [0, seed << 8, 0, 0]));
    const rows: Rows = { count: puffs.length, whole: puffs.length, place, attributes };
    moves = Float32Array.from(placed.flatMap(({ move }) => move));
    return { rows, bounds: { min: [0, 0, 0], max: [0, 0, 0], greatestRadius: 1 } as const, grid: undefined };
  };
  return { arrange, moves: () => moves };
}

function cameraAt(z: number): PerspectiveCamera {
  const camera = new PerspectiveCamera(40, WIDTH / HEIGHT);
  camera.position.z = z;
  camera.updateMatrixWorld();
  return camera;
}

const CAMERA = cameraAt(10);

const STYLE = styleOf(defaults());

function inputOf(...puffs: Puff[]): FrameInput {
  const light = { kind: 'sun', towards: new Vector3(0, 1, 0) } as const;
  const simulator = smokeOf(puffs);
  return { simulator, camera: CAMERA, light, rigids: [], blend: 1, style: STYLE } as unknown as FrameInput;
}

/** Vector at the pixel that shows a place, in fractions of the frame. */
function vectorAt(pixels: Uint8ClampedArray, place: readonly number[]): number[] {
  const { x, y } = new Vector3(...place).project(CAMERA);
  const pixel = Math.floor(((1 - y) / 2) * HEIGHT) * WIDTH + Math.floor(((1 + x) / 2) * WIDTH);
  return [0, 1].map((channel) => MOTION_RANGE * (pixels[4 * pixel + channel] / 127.5 - 1));
}

/** Where a puff is seen and how far it moves until the next frame, as computed from its two projections. */
function expected({ from, move }: Puff): { place: number[]; vector: number[] } {
  const place = from.map((x, axis) => x + move[axis]);
  const [here, next] = [1, 1 + STEPS].map((steps) =>
    new Vector3(...from.map((x, axis) => x + steps * move[axis])).project(CAMERA),
  );
  return { place, vector: [(next.x - here.x) / 2, (next.y - here.y) / 2] };
}

const ROUNDING = MOTION_RANGE / 127;

function expectVector(pixels: Uint8ClampedArray, puff: Puff): void {
  const { place, vector } = expected(puff);
  const found = vectorAt(pixels, place);
  expect(Math.abs(found[0] - vector[0])).toBeLessThan(ROUNDING);
  expect(Math.abs(found[1] - vector[1])).toBeLessThan(ROUNDING);
}

const RISING: Puff = { from: [-1, 0, 0], move: [0.02, 0.11, 0.05], radius: 0.8, seed: 3 };
const PASSING: Puff = { from: [1.5, 0.5, -2], move: [-0.1, -0.03, 0], radius: 0.8, seed: 7 };

describe('drawMotion', () => {
  it('is the projected movement until the next frame, x to the right and y up', () => {
    const pixels = drawMotion(inputOf(RISING, PASSING), WIDTH, HEIGHT, RATE);
    expectVector(pixels, RISING);
    expectVector(pixels, PASSING);
    expect([...pixels.subarray(0, 4)]).toEqual([128, 128, 0, 255]);
  });

  it('finds puffs again when others pass them', () => {
    const still = { ...RISING, move: [0, 0, 0], seed: 9 } as const;
    const crossing: Puff = { from: [-1.05, 1.9, 0], move: [0.1, 0, 0], radius: 0.8, seed: 4 };
    const pixels = drawMotion(inputOf(still, crossing), WIDTH, HEIGHT, RATE);
    expectVector(pixels, still);
    expectVector(pixels, crossing);
  });

  it('shows the nearer of two puffs', () => {
    const behind: Puff = { ...RISING, from: [-1.1, 0, -3], move: [0.1, 0, 0], seed: 5 };
    for (const puffs of [
      [RISING, behind],
      [behind, RISING],
    ]) {
      expectVector(drawMotion(inputOf(...puffs), WIDTH, HEIGHT, RATE), RISING);
    }
  });

  it('clamps fast movement to its range', () => {
    const fast: Puff = { from: [0, 0, 0], move: [1, -1, 0], radius: 2, seed: 1 };
    const pixels = drawMotion(inputOf(fast), WIDTH, HEIGHT, RATE);
    expect([...vectorAt(pixels, [1, -1, 0])]).toEqual([MOTION_RANGE, -MOTION_RANGE]);
  });

  it('has the vectors of both times during a transition', () => {
    const between = joined(inputOf(RISING), stillOf(inputOf(PASSING)), 0.3);
    const pixels = drawMotion(between, WIDTH, HEIGHT, RATE);
    expectVector(pixels, RISING);
    expectVector(pixels, PASSING);
  });

  it('ignores puffs behind the camera', () => {
    const pixels = drawMotion(inputOf({ ...RISING, from: [0, 0, 30] }), WIDTH, HEIGHT, RATE);
    expect(new Set(new Uint32Array(pixels.buffer)).size).toBe(1);
  });
});
