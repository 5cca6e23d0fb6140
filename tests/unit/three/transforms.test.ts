import { BoxGeometry, Mesh, Object3D, Vector3, type Group } from 'three';
import { beforeAll, expect, test } from 'vitest';
import { ParameterError } from '../../../src/base/errors.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { simulatorValues } from '../../../src/simulator/simulatorValues.ts';
import { SmokeFrame, type SmokeSpace } from '../../../src/three/smokeSpace.ts';
import { HandledSmoke, STILL } from '../../support/handledSmoke.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

let factory: SimulatorFactory;
beforeAll(async () => {
  factory = await loadVariant('physics');
});

/** Puffs at rest that leave one point, a metre above the origin of the smoke. */
const NOZZLE: Values = {
  ...STILL,
  'emission.rate': 600,
  'emitters.0.shape': 'point',
  'emitters.0.speed': 0,
  'emitters.0.position.y': 1,
};
const RESTING = { speed: 0, shape: 'point' } as const;
const QUARTER = Math.PI / 2;

function smokeIn(space: SmokeSpace, values: Values = NOZZLE): HandledSmoke {
  return new HandledSmoke(factory, values, 4000, space);
}

/** Places in the world of puffs in local smoke. */
function worldPlaces(smoke: HandledSmoke): Vector3[] {
  smoke.object.updateWorldMatrix(true, false);
  return smoke.places().map((place) => new Vector3(...place).applyMatrix4(smoke.object.matrixWorld));
}

/** Places without duplicates, in millimetres. */
function distinct(places: readonly (readonly number[] | Vector3)[]): Set<string> {
  return new Set(places.map((place) => [...place].map((each) => Math.round(1000 * each) + 0).join()));
}

function runs<Result>(...each: (() => Result)[]): Result[] {
  return each.map((run) => run());
}

test('without a transform the smoke is that of a simulator alone, in either space', () => {
  const values = { ...NOZZLE, 'buoyancy.acceleration': 1, 'forces.wind.x': 0.5, 'colliders.0.position.y': 0.5 };
  const alone = factory.create({ capacity: 4000, seed: 7 });
  alone.set(simulatorValues(values));
  alone.step(40);
  for (const space of ['world', 'local'] as const) {
    const smoke = smokeIn(space, values);
    smoke.frames(40);
    expect(smoke.simulator.hash()).toBe(alone.hash());
  }
});

test('in the world, puffs stay and new ones come from the emitters of the table in the space of the object', () => {
  const smoke = smokeIn('world');
  smoke.frames(20);
  smoke.object.position.set(3, 0, 0);
  smoke.object.rotation.z = QUARTER;
  smoke.frames(20);
  expect(distinct(smoke.places())).toEqual(new Set(['0,1000,0', '2000,0,0']));
  // A motion below 120 m/s leaves an even trail.
  smoke.object.position.set(4.5, 0, 0);
  smoke.frame(3);
  smoke.frame();
  const along = smoke.places().map(([x]) => x);
  for (const place of [2.25, 2.75, 3.25]) expect(along.filter((x) => Math.abs(x - place) < 0.126)).toHaveLength(5);
});

test('while the transform is invalid, smoke goes on at the last valid one', () => {
  const smoke = smokeIn('world');
  smoke.object.position.x = 1;
  smoke.frame();
  smoke.object.position.x = 1.5;
  smoke.frame();
  smoke.object.position.y = NaN;
  smoke.frames(9);
  expect(smoke.errors).toHaveLength(9);
  const along = smoke.places().map(([x]) => x);
  expect(along.filter((x) => Math.abs(x - 1.5) < 0.001).length).toBeGreaterThan(80);
  expect(along.filter((x) => x > 1.001 && x < 1.499).length).toBeLessThan(11);
});

test('in the world, a smoke that is placed before its first step starts there, also in a parent', () => {
  const smoke = smokeIn('world');
  const parent = new Object3D();
  parent.position.set(0, 1, 0);
  smoke.scene.add(parent);
  parent.add(smoke.object);
  smoke.object.position.x = 0.25;
  smoke.place();
  smoke.object.position.x = 0.5;
  smoke.frames(10);
  expect(distinct(smoke.places())).toEqual(new Set(['500,2000,0']));
});

test('obstacles do not move when smoke is placed before its first step', () => {
  const run = (isPlacedFirst: boolean) => {
    const smoke = smokeIn('local', { ...NOZZLE, 'emitters.0.radius': 0.5, 'emitters.0.shape': 'ball' });
    const place = () => smoke.object.position.set(1.25, 0, 0);
    if (isPlacedFirst) place();
    smoke.collide(smoke.put(new Mesh(new BoxGeometry(1, 4, 4)), 0.5));
    place();
    smoke.frames(5);
    return smoke.simulator.hash();
  };
  const [first, later] = runs(
    () => run(true),
    () => run(false),
  );
  expect(later).toBe(first);
});

test('in the world, forces and obstacles of the table follow the object, and gravity does not', () => {
  const smoke = smokeIn('world', { ...NOZZLE, 'emission.rate': 0, 'gravities.0.acceleration.y': -2 });
  smoke.object.rotation.z = QUARTER;
  void smoke.pool.burst({ ...RESTING, position: { x: 1, y: 2, z: 0 }, count: 1 });
  smoke.frames(60);
  const [[x, y, z]] = smoke.places();
  expect([x, y, z]).toEqual([expect.closeTo(2, 1), expect.closeTo(2, 3), expect.closeTo(0, 3)]);

  const falling = smokeIn('world', { ...NOZZLE, 'emission.rate': 0, 'gravity.acceleration': 3 });
  falling.object.position.y = 4;
  falling.object.rotation.z = 0.3;
  void falling.pool.burst({ ...RESTING, position: { x: 2, y: 6, z: 0 }, count: 1, size: 0.2, sizeVariation: 0 });
  // A value that is set later follows, too.
  falling.set({ 'colliders.0.shape': 'plane', 'colliders.0.restitution': 0, 'colliders.0.friction': 1 });
  falling.frames(120);
  const [place] = falling.places();
  const normal = [-Math.sin(0.3), Math.cos(0.3)];
  const above = normal[0] * place[0] + normal[1] * (place[1] - 4);
  expect(above).toBeGreaterThan(0);
  expect(above).toBeLessThan(0.35);
});

test('in the world, items that ride on other objects do not ride on the smoke', () => {
  const smoke = smokeIn('world', { ...NOZZLE, 'emitters.0.position.y': 0, 'emitters.1.shape': 'point' });
  smoke.set({ 'emitters.1.speed': 0, 'emitters.0.share': 1, 'emitters.1.share': 1 });
  smoke.object.position.set(10, 0, 0);
  smoke.emitFrom(smoke.put(new Object3D(), 2), 0);
  const handle = smoke.attach('emitters.1', smoke.put(new Object3D(), -3));
  smoke.frames(20);
  expect(distinct(smoke.places())).toEqual(new Set(['2000,0,0', '-3000,0,0']));
  handle.remove();
  smoke.frames(20);
  expect(distinct(smoke.places())).toEqual(new Set(['2000,0,0', '-3000,0,0', '10000,0,0']));
});

test('local smoke is the same wherever its object goes', () => {
  const values = { ...NOZZLE, 'emitters.0.speed': 2, 'emitters.0.spread': 1, 'turbulence.speed': 0.5, seed: 7 };
  const run = (move: (object: Group, frame: number) => void, more: Values = {}) => {
    const smoke = smokeIn('local', { ...values, ...more });
    for (let frame = 0; frame < 40; frame++) {
      move(smoke.object, frame);
      smoke.frame();
    }
    return smoke.simulator.hash();
  };
  const [still, spinning, jumping, large] = runs(
    () => run(() => {}),
    () => run((object, frame) => object.rotation.set(0.1 * frame, 0.2, 0.05 * frame)),
    () => run((object, frame) => object.position.set(7 * frame, -3 * frame, 1e4)),
    () => run((object) => object.scale.setScalar(4)),
  );
  expect([spinning, jumping, large]).toEqual([still, still, still]);
  // With gravity: as long as up is up.
  const heavy = { 'gravity.acceleration': 1, 'buoyancy.acceleration': 0.5 };
  const [upright, yawing, tilted] = runs(
    () => run(() => {}, heavy),
    () => run((object, frame) => (object.rotation.y = 0.1 * frame), heavy),
    () => run((object) => (object.rotation.z = 0.1), heavy),
  );
  expect(yawing).toBe(upright);
  expect(tilted).not.toBe(upright);
});

test.each([
  ['gravity', { 'gravity.acceleration': 1 }, [0, -0.5, 0]],
  ['buoyancy', { 'buoyancy.acceleration': 1, 'buoyancy.coolingTime': 1000 }, [0, 0.5, 0]],
  ['the wind', { 'forces.wind.x': 0.4, 'forces.wind.z': -0.2 }, [0.4, 0, -0.2]],
] as const)('in local smoke, %s keeps its direction in the world', (_, values: Values, way) => {
  const smoke = smokeIn('local', { ...NOZZLE, 'emission.rate': 0, ...values });
  smoke.object.position.set(1, 2, 3);
  smoke.object.rotation.set(0.7, 0.9, -1.2);
  smoke.place();
  void smoke.pool.burst({ ...RESTING, position: { x: 2, y: 1, z: 0 }, count: 1 });
  smoke.frames(60);
  const [place] = worldPlaces(smoke);
  const expected = [2 + way[0], 1 + way[1], way[2]];
  [...place].forEach((each, axis) => expect(each).toBeCloseTo(expected[axis], 1));
  // Upright again, the wind is that of the values.
  smoke.object.rotation.set(0, 0, 0);
  smoke.frame();
  smoke.frame();
  const upright = smokeIn('local', { ...NOZZLE, 'emission.rate': 0, ...values });
  expect(smoke.simulator.parameters().get('forces.wind.x')).toBe(upright.simulator.parameters().get('forces.wind.x'));
});

test('in local smoke, bursts and emitters of handles are where they are in the world', () => {
  const smoke = smokeIn('local', { ...NOZZLE, 'emitters.0.position.y': 0 });
  smoke.object.position.set(1, 2, 3);
  smoke.object.rotation.set(0.7, 0.9, -1.2);
  smoke.place();
  const fast = { shape: 'point', speed: 3, speedVariation: 0, spread: 0 } as const;
  void smoke.pool.burst({ ...fast, position: { x: 5, y: 0, z: 0 }, direction: { x: 0, y: 0, z: -2 }, count: 1 });
  smoke.frames(60);
  // Births are spread over the first step.
  const flown = worldPlaces(smoke).find(({ x }) => x > 4)!;
  [5, 0, -3].forEach((each, axis) => expect(Math.abs(flown.getComponent(axis) - each)).toBeLessThan(0.06));
  const anchor = smoke.put(new Object3D(), -2);
  smoke.emitFrom(anchor, 0);
  smoke.emitFrom(smoke.put(new Object3D(), -4), RESTING);
  smoke.frames(9);
  const spots = distinct(worldPlaces(smoke));
  for (const spot of ['-2000,0,0', '-4000,0,0', '1000,2000,3000']) expect(spots).toContain(spot);
});

/** A box that comes towards puffs at rest: it moves, or the smoke does. Dyadic numbers have no rounding. */
function swept(space: SmokeSpace, isBoxMoving: boolean): [string, number] {
  const smoke = smokeIn(space, { ...NOZZLE, 'emission.rate': 0 });
  const box = smoke.put(new Mesh(new BoxGeometry(1, 4, 4)), -2);
  smoke.collide(box, { restitution: 0 });
  void smoke.pool.burst({ ...RESTING, position: { x: 0, y: 1, z: 0 }, count: 4, shape: 'ball', radius: 0.25 });
  for (let frame = 0; frame < 64; frame++) {
    if (isBoxMoving) box.position.x += 1 / 32;
    else smoke.object.position.x -= 1 / 32;
    smoke.frame();
  }
  const least = Math.min(...smoke.places().map(([x]) => x));
  return [smoke.simulator.hash(), least];
}

test('an object at rest is a moving obstacle of moving local smoke', () => {
  const [[hash, least], [moved, minMoved], [, untouched]] = runs(
    () => swept('local', false),
    () => swept('local', true),
    () => swept('world', false),
  );
  expect(hash).toBe(moved);
  expect(minMoved).toBeGreaterThan(0.4);
  expect(least).toBe(minMoved);
  // Smoke in the world does not come nearer.
  expect(untouched).toBeLessThan(0);
});

test('a jump of local smoke places obstacles as new ones, without speed', () => {
  const run = (steps: number, isNew: boolean) => {
    const smoke = smokeIn('local', { ...NOZZLE, 'emission.rate': 0 });
    const handle = smoke.collide(smoke.put(new Mesh(new BoxGeometry(1, 4, 4)), -10));
    void smoke.pool.burst({ ...RESTING, position: { x: 0, y: 1, z: 0 }, count: 30, shape: 'ball', radius: 0.5 });
    smoke.frame();
    if (isNew) handle.enabled = false;
    smoke.frames(9);
    handle.enabled = true;
    for (let step = 0; step < steps; step++) {
      smoke.object.position.x -= 9.25 / steps;
      smoke.frame();
    }
    smoke.frames(20);
    return smoke.simulator.hash();
  };
  const [jumped, fresh, flown] = runs(
    () => run(1, false),
    () => run(1, true),
    () => run(8, false),
  );
  expect(jumped).toBe(fresh);
  expect(flown).not.toBe(fresh);
});

test('a scale enlarges the smoke with the places of handles, bursts and obstacles', () => {
  const run = (space: SmokeSpace, scale: number) => {
    const smoke = smokeIn(space, { ...NOZZLE, 'emitters.0.speed': 1, 'gravity.acceleration': 0.5 });
    smoke.object.scale.setScalar(scale);
    smoke.collide(smoke.put(new Mesh(new BoxGeometry(scale, scale, scale)), scale), { friction: 0.5 });
    smoke.emitFrom(smoke.put(new Object3D(), -scale), { rate: 30, size: 0.2 });
    void smoke.pool.burst({ position: { x: 0, y: 2 * scale, z: 0 }, count: 5 });
    smoke.frames(60);
    return smoke.simulator.hash();
  };
  const hashes = runs(
    () => run('world', 1),
    () => run('world', 2),
    () => run('local', 4),
    () => run('local', 0.5),
  );
  expect(new Set(hashes).size).toBe(1);
});

test('a change of the scale keeps the origin of the object, and makes obstacles again', () => {
  const smoke = smokeIn('world');
  smoke.object.position.set(2, 0, 0);
  smoke.frames(10);
  // Half as large in the smoke from then on, at -1 instead of -4.
  smoke.collide(smoke.put(new Mesh(new BoxGeometry(2, 2, 2)), -4), { restitution: 0 });
  smoke.object.scale.setScalar(2);
  smoke.frames(10);
  expect(distinct(smoke.places())).toEqual(new Set(['2000,1000,0']));
  void smoke.pool.burst({ ...RESTING, position: { x: -3.1, y: 0, z: 0 }, count: 1, size: 0.01 });
  smoke.frames(10);
  const along = smoke.places().map(([x]) => x);
  expect(Math.min(...along)).toBeGreaterThan(-0.5);
  expect(Math.min(...along)).toBeLessThan(-0.4);
});

test('an object that feels smoke travels with local smoke, and falls down in the world', () => {
  const fall = (isChild: boolean, speed: number, tilt: number) => {
    const smoke = smokeIn('local', { ...NOZZLE, 'emission.rate': 0 });
    smoke.object.rotation.z = tilt;
    smoke.object.updateMatrixWorld();
    const lantern = new Mesh(new BoxGeometry(0.25, 0.25, 0.25));
    (isChild ? smoke.object : smoke.scene).add(lantern);
    smoke.collide(lantern, { feelsSmoke: true });
    for (let frame = 0; frame < 30; frame++) {
      smoke.object.position.x += speed / 64;
      smoke.frame();
    }
    return lantern.getWorldPosition(new Vector3());
  };
  const fallen = (9.81 * 0.25) / 2;
  for (const isChild of [true, false]) {
    for (const [speed, tilt] of [
      [0, 0],
      [1, 0],
      [0, 0.8],
    ]) {
      const { x, y } = fall(isChild, speed, tilt);
      expect(y).toBeCloseTo(-fallen, 1);
      expect(x).toBeCloseTo((speed * 30) / 64, 2);
    }
  }
});

test.each([
  ['NaN', (object: Object3D) => void (object.position.x = NaN), /at NaN, 2, 0/],
  ['scales that differ', (object: Object3D) => void object.scale.set(1, 2, 1), /scale 1, 2, 1/],
  ['a mirror', (object: Object3D) => void object.scale.set(-1, 1, 1), /mirrored/],
  ['a scale of 0', (object: Object3D) => void object.scale.set(0, 0, 0), /scale 0, 0, 0/],
  ['a place beyond 5,000 m', (object: Object3D) => void object.position.setX(6000), /at 6000, 2, 0/],
])('%s is an error with the transform, and the last valid one stays', (_, spoil, message) => {
  const frame = new SmokeFrame('world');
  const object = new Object3D();
  object.position.y = 2;
  frame.look(object, 1);
  spoil(object);
  expect(() => frame.look(object, 1)).toThrow(ParameterError);
  expect(() => frame.look(object, 1)).toThrow(message);
  expect(frame.object.position.y).toBe(2);
  expect(frame.now.scale).toBe(1);
});
