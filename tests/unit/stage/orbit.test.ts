import fc from 'fast-check';
import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { decode, encode, defaultState } from '../../../src/parameters/codec.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { table } from '../../../src/parameters/table.ts';
import { validate } from '../../../src/parameters/values.ts';
import type { Scene } from '../../../src/scenes/scene.ts';
import { OrbitCamera } from '../../../src/stage/orbit.ts';

const KEYS = table.filter(({ reader }) => reader === 'camera').map(({ key }) => key);
const STILL: Pick<Scene, 'camera' | 'portrait' | 'cameraMove'> = {
  camera: { target: [0, 1, 0], azimuth: 0.2, elevation: 0.3, distance: 6, fieldOfView: 0.6 },
};
const MOVING = {
  ...STILL,
  cameraMove: (seconds: number) => ({ azimuth: seconds / 10, target: [0, seconds, 0] as const }),
};

/** Projection of a point in normalized device coordinates. */
function seen(eye: OrbitCamera, point = new Vector3(0.5, 1.5, 0.3)): number[] {
  return point.clone().project(eye.camera).toArray();
}

type Act = (eye: OrbitCamera) => void;

const anyAct: fc.Arbitrary<Act> = fc.oneof(
  fc.tuple(fc.double({ min: -9, max: 9, noNaN: true }), fc.double({ min: -4, max: 4, noNaN: true })).map(
    ([azimuth, elevation]): Act =>
      (eye) =>
        eye.orbit(azimuth, elevation),
  ),
  fc.double({ min: 0.01, max: 100, noNaN: true }).map(
    (factor): Act =>
      (eye) =>
        eye.zoom(factor),
  ),
  fc.tuple(fc.integer({ min: -900, max: 900 }), fc.integer({ min: -900, max: 900 })).map(
    ([x, y]): Act =>
      (eye) =>
        eye.pan(x, y, 720),
  ),
);

describe('a camera that the user moves', () => {
  it('has values that the table accepts, and a link restores exactly the same view', async () => {
    await fc.assert(
      fc.asyncProperty(fc.array(anyAct, { minLength: 1, maxLength: 12 }), async (acts) => {
        const eye = new OrbitCamera(STILL);
        for (const act of acts) act(eye);
        validate(eye.held);
        const { preset, values } = defaultState();
        const { state, notices } = await decode(await encode({ preset, values: { ...values, ...eye.held } }));
        expect(notices).toEqual([]);
        const other = new OrbitCamera(STILL, state.values);
        expect(other.held).toEqual(eye.held);
        expect(other.camera.matrixWorld.elements).toEqual(eye.camera.matrixWorld.elements);
      }),
      { numRuns: 200 },
    );
  });

  it('follows a rotation to within a hundredth of a degree', () => {
    const eye = new OrbitCamera(STILL);
    eye.orbit(0.1, -0.05);
    expect(eye.azimuth).toBeCloseTo(0.3, 3);
    expect(eye.held).toEqual({ 'camera.azimuth': 17.19, 'camera.elevation': 14.32 });
  });

  it('stays within the ranges of the table, and orbits without a limit', () => {
    const eye = new OrbitCamera(STILL);
    eye.orbit(Math.PI, 9);
    eye.zoom(1000);
    expect(eye.held).toMatchObject({ 'camera.elevation': 88, 'camera.distance': 0.3 });
    expect(eye.held['camera.azimuth']).toBeCloseTo(-180 + 11.46, 2);
    eye.orbit(0, -9);
    eye.zoom(0.001);
    expect(eye.held).toMatchObject({ 'camera.elevation': -5, 'camera.distance': 40 });
  });
});

describe('a camera that the user has not moved', () => {
  it('follows the scene and its animation, each part separately', () => {
    const eye = new OrbitCamera(MOVING);
    eye.moveTo(2);
    expect(eye.azimuth).toBeCloseTo(0.4, 12);
    eye.orbit(0, 0);
    eye.moveTo(4);
    expect(eye.azimuth).toBeCloseTo(0.4, 3);
    expect(eye.centre.y).toBe(5);
    expect(eye.wanted).toMatchObject({ 'camera.azimuth': 34.38, 'camera.target.y': 5, 'camera.distance': 6 });
  });

  it('follows the scene again after a reset', () => {
    const eye = new OrbitCamera(MOVING);
    const untouched = new OrbitCamera(MOVING);
    eye.orbit(1, 1);
    eye.pan(50, 20, 720);
    for (const each of [eye, untouched]) each.moveTo(3);
    expect(seen(eye)).not.toEqual(seen(untouched));
    eye.override({ 'puff.size': 2 });
    expect(eye.held).toEqual({});
    expect(seen(eye)).toEqual(seen(untouched));
  });

  it('is composed differently for a portrait picture', () => {
    const eye = new OrbitCamera({ ...STILL, portrait: { distance: 9 } }, { 'camera.azimuth': 90 });
    eye.setSize(0.5, 1);
    expect([eye.distance, eye.azimuth]).toEqual([9, Math.PI / 2]);
  });
});

it('every key of the table moves the view', () => {
  const views = KEYS.map((key) => {
    const values: Values = { [key]: 20 };
    return seen(new OrbitCamera(STILL, values));
  });
  expect(KEYS).toHaveLength(6);
  for (const view of views) expect(view).not.toEqual(seen(new OrbitCamera(STILL)));
});
