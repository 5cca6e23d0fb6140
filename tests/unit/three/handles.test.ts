import { BoxGeometry, Group, Mesh, Object3D, PlaneGeometry, SphereGeometry, Vector3 } from 'three';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { beforeAll, expect, test } from 'vitest';
import { ParameterError, SimulatorError } from '../../../src/base/errors.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { POSE_FLOATS } from '../../../src/simulator/layout.ts';
import { HandledSmoke, STILL } from '../../support/handledSmoke.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

let factory: SimulatorFactory;
beforeAll(async () => {
  factory = await loadVariant('physics');
});

const RESTING = { speed: 0, shape: 'point' } as const;

test('an emitter follows its object with a rate of its own and puts out even trails', () => {
  const smoke = new HandledSmoke(factory);
  const object = smoke.put(new Object3D());
  smoke.emitFrom(object, { ...RESTING, rate: 120 });
  for (let frame = 1; frame <= 30; frame++) {
    object.position.x = frame / 10;
    smoke.frame(2);
  }
  const along = smoke.places().map(([x]) => x);
  along.sort((a, b) => a - b);
  expect(smoke.simulator.alive).toBe(120);
  // The last one, born at the end of the step, is not drawn yet.
  expect(along).toHaveLength(119);
  along.forEach((x, birth) => expect(x).toBeCloseTo((birth + 1) / 40, 3));
  smoke.simulator.dispose();
});

test('an object that jumps leaves no trail', () => {
  const smoke = new HandledSmoke(factory);
  const object = smoke.put(new Object3D());
  smoke.emitFrom(object, { ...RESTING, rate: 600 });
  smoke.frames(3);
  object.position.x = 4.2;
  smoke.frames(3);
  expect(new Set(smoke.places().map(([x]) => x.toFixed(3)))).toEqual(new Set(['0.000', '4.200']));
  // The same way in three steps is a fast motion.
  object.position.x = 0;
  smoke.frame(3);
  expect(smoke.places().filter(([x]) => x > 0.1 && x < 4.1).length).toBeGreaterThan(25);
  smoke.simulator.dispose();
});

test('options, set and burst reach the simulator, and remove ends the emission', () => {
  const smoke = new HandledSmoke(factory);
  const emitter = smoke.emitFrom(smoke.put(new Object3D(), 2), { ...RESTING, rate: 0 });
  smoke.frames(10);
  expect(smoke.simulator.alive).toBe(0);
  void emitter.burst(25);
  smoke.frame();
  expect(smoke.places()).toEqual(Array.from({ length: 25 }, () => [2, 0, 0]));
  emitter.set({ rate: 60 });
  smoke.frames(60);
  expect(smoke.simulator.alive).toBe(85);
  // The options that `set` does not name stay.
  expect(new Set(smoke.places().map(String))).toEqual(new Set(['2,0,0']));
  emitter.remove();
  emitter.remove();
  smoke.frames(60);
  expect(smoke.simulator.alive).toBe(85);
  smoke.simulator.dispose();
});

test('a burst comes once, at its place, in its direction and with its speed', () => {
  const smoke = new HandledSmoke(factory);
  const [position, direction] = [new Vector3(1, 2, 3), new Vector3(0, 0, -8)];
  void smoke.pool.burst({ position, direction, count: 40, speed: 6, speedVariation: 0, spread: 0, shape: 'point' });
  smoke.frames(61);
  const places = smoke.places();
  expect(places).toHaveLength(40);
  for (const [x, y, z] of places) {
    expect([x, y]).toEqual([1, 2]);
    // Births are spread over the first step.
    expect(Math.abs(z - (3 - 6.05))).toBeLessThan(0.06);
  }
  smoke.simulator.dispose();
});

test('a burst has no options of the one before', () => {
  const smoke = new HandledSmoke(factory);
  const position = new Vector3(0, 5, 0);
  void smoke.pool.burst({ ...RESTING, position, count: 1, temperature: 3, spread: 0 });
  void smoke.pool.burst({ position, count: 200, direction: { x: 0, y: 0, z: 1 } });
  smoke.frames(30);
  const moved = smoke.places().filter(([, , z]) => z > 0.1);
  expect(moved).toHaveLength(200);
  expect(new Set(moved.map(([x]) => x)).size).toBeGreaterThan(100);
  smoke.simulator.dispose();
});

test('without a direction a burst goes in all directions', () => {
  const smoke = new HandledSmoke(factory);
  void smoke.pool.burst({ position: { x: 0, y: 0, z: 0 }, count: 400, speed: 5 });
  smoke.frames(30);
  const places = smoke.places();
  for (const axis of [0, 1, 2]) {
    const share = places.filter((place) => place[axis] > 0).length / places.length;
    expect(Math.abs(share - 0.5)).toBeLessThan(0.1);
  }
  smoke.simulator.dispose();
});

test('thousands of bursts lose nothing while there is room, and the hash depends on the calls only', () => {
  const run = (count: number) => {
    const smoke = new HandledSmoke(factory, STILL, 20_000);
    for (let burst = 0; burst < 2000; burst++) {
      void smoke.pool.burst({ position: { x: burst % 7, y: 0, z: 0 }, count, tint: burst % 16 });
      if (burst % 200 === 199) smoke.frame();
    }
    const { alive } = smoke.simulator;
    const hash = smoke.simulator.hash();
    smoke.simulator.dispose();
    return { alive, hash };
  };
  const first = run(5);
  expect(first.alive).toBe(10_000);
  expect(run(5)).toEqual(first);
  expect(run(6).hash).not.toBe(first.hash);
});

test('bursts create no objects', () => {
  const smoke = new HandledSmoke(factory);
  const burst = { position: new Vector3(), direction: new Vector3(0, 1, 0), count: 1, speed: 4, size: 0.25, tint: 3 };
  const bytesPerBurst = () => {
    const before = process.memoryUsage().heapUsed;
    for (let count = 0; count < 5000; count++) void smoke.pool.burst(burst);
    return (process.memoryUsage().heapUsed - before) / 5000;
  };
  // V8 may box the seven numbers of the options, 16 bytes each, and more until it has optimised the code, which takes longer
  // on a busy machine. Closures and arrays would be 380 bytes.
  expect(Math.min(...Array.from({ length: 20 }, bytesPerBurst))).toBeLessThan(200);
  smoke.simulator.dispose();
});

test('a pool that is not used leaves the hash alone, and a table emitter moves as before', () => {
  const values = { ...STILL, 'emission.rate': 60, 'emitters.0.share': 1 };
  const smoke = new HandledSmoke(factory, values);
  const plain = new HandledSmoke(factory, values);
  const object = smoke.put(new Object3D());
  smoke.emitFrom(object, 0);
  for (let frame = 0; frame < 40; frame++) {
    object.position.set(frame / 8, 1, 0);
    smoke.frame();
    plain.simulator.set({
      'emitters.0.position.x': frame / 8,
      'emitters.0.position.y': 1,
      'emitters.0.position.z': 0,
      'emitters.0.direction.x': 0,
      'emitters.0.direction.y': 1,
      'emitters.0.direction.z': 0,
    });
    plain.simulator.step();
  }
  expect(smoke.simulator.hash()).toBe(plain.simulator.hash());
  smoke.simulator.dispose();
  plain.simulator.dispose();
});

test('a table emitter is silent while it is disabled, keeps the rates of the others, and takes options', () => {
  const values = { ...STILL, 'emission.rate': 120, 'emitters.0.share': 1, 'emitters.1.share': 1 };
  const smoke = new HandledSmoke(factory, values);
  const first = smoke.emitFrom(smoke.put(new Object3D(), 10), 0);
  const second = smoke.emitFrom(smoke.put(new Object3D(), -10), 1);
  const counts = () => [1, -1].map((side) => smoke.places().filter(([x]) => x * side > 0).length);
  smoke.frames(60);
  // A puff that is born at the end of the step is not drawn yet.
  expect(counts()).toEqual([59, 59]);
  first.enabled = false;
  smoke.frame();
  // The values of the table must not wake it.
  smoke.set({ 'emitters.0.envelope.duration': 0, 'emitters.0.speed': 1 });
  smoke.frames(59);
  expect(counts()).toEqual([60, 119]);
  first.enabled = true;
  second.set({ speed: 3, extent: { x: 1, y: 2, z: 3 } });
  smoke.frames(60);
  expect(counts()).toEqual([119, 179]);
  expect(smoke.simulator.parameters().get('emitters.1.speed')).toBe(3);
  expect(smoke.simulator.parameters().get('emitters.1.extent.z')).toBe(3);
  first.remove();
  void second.burst(7);
  smoke.frames(60);
  expect(counts()).toEqual([120, 246]);
  smoke.emitFrom(smoke.put(new Object3D(), 10), 0);
  smoke.frames(60);
  expect(counts()).toEqual([179, 306]);
  // Of two handles of an emitter one is enough.
  smoke.emitFrom(smoke.put(new Object3D(), 10), 0).remove();
  smoke.frames(60);
  expect(counts()).toEqual([239, 366]);
  smoke.simulator.dispose();
});

test('a force rides on an object, pauses with it and stays where its values are after remove', () => {
  const smoke = new HandledSmoke(factory, { ...STILL, 'jets.0.speed': 8, 'jets.0.radius': 5, 'jets.0.reach': 50 });
  const { simulator } = smoke;
  const object = smoke.put(new Object3D(), 100);
  object.rotation.z = -Math.PI / 2;
  const handle = smoke.attach('jets.0', object);
  const drift = () => {
    void smoke.pool.burst({ ...RESTING, position: { x: 101, y: 0, z: 0 }, count: 1 });
    smoke.frames(20);
    return smoke.places().at(-1)![0] - 101;
  };
  const pushed = Math.max(...[drift()].map(Math.abs));
  expect(pushed).toBeGreaterThan(0.5);
  expect(simulator.parameters().get('jets.0.rigid')).toBe(4096);
  handle.enabled = false;
  smoke.frame();
  const before = smoke.places();
  smoke.frames(20);
  expect(smoke.places()).toEqual(before);
  expect(() => smoke.attach('jets.0', object)).toThrow(/^attach cannot be “jets\.0”: .*remove its handle/);
  handle.remove();
  expect(simulator.parameters().get('jets.0.rigid')).toBe(-1);
  expect(simulator.parameters().get('jets.0.envelope.duration')).toBe(0);
  smoke.attach('jets.0', object);
  simulator.dispose();
});

test.each(['emitter', 'table emitter', 'force', 'collider'] as const)(
  'a %s pauses while its object is out of the scene or has no sound transform, with one error, and returns',
  (kind) => {
    const rate = kind === 'table emitter' ? 60 : 0;
    const smoke = new HandledSmoke(factory, {
      ...STILL,
      'emission.rate': rate,
      'emitters.0.share': 1,
      'jets.0.speed': 1,
    });
    const { simulator } = smoke;
    const object = smoke.put(new Mesh(new SphereGeometry()), 3);
    if (kind === 'emitter') smoke.emitFrom(object, { rate: 60 });
    if (kind === 'table emitter') smoke.emitFrom(object, 0);
    if (kind === 'force') smoke.attach('jets.0', object);
    if (kind === 'collider') smoke.collide(object);
    const isOn = () => {
      smoke.frame();
      if (kind === 'force') return simulator.parameters().get('jets.0.envelope.duration') === 0;
      if (kind === 'collider') return isThere(smoke, 0);
      const before = simulator.alive;
      smoke.frames(30);
      return simulator.alive - before === 30;
    };
    expect(isOn()).toBe(true);
    smoke.scene.remove(object);
    expect(isOn()).toBe(false);
    smoke.scene.add(object);
    expect(isOn()).toBe(true);
    expect(smoke.errors).toEqual([]);
    object.position.y = NaN;
    expect(isOn()).toBe(false);
    expect(isOn()).toBe(false);
    expect(smoke.errors).toHaveLength(1);
    expect(smoke.errors[0]).toBeInstanceOf(ParameterError);
    expect(String(smoke.errors[0])).toMatch(/(emitFrom|attach|collide)\.object cannot be “Mesh at NaN, NaN, NaN”/);
    object.position.y = 0;
    expect(isOn()).toBe(true);
    object.position.y = Infinity;
    expect(isOn()).toBe(false);
    expect(smoke.errors).toHaveLength(2);
    simulator.dispose();
  },
);

/** Whether a puff that flies against the place of a ball of radius 1 at x = 3 is stopped there. */
function isThere(smoke: HandledSmoke, from: number): boolean {
  const probe = new HandledSmoke(factory);
  probe.simulator.restore(smoke.simulator.save());
  void probe.pool.burst({
    position: { x: from, y: 0, z: 0 },
    direction: { x: 1, y: 0, z: 0 },
    count: 1,
    speed: 10,
    speedVariation: 0,
    spread: 0,
    size: 0.01,
    shape: 'point',
  });
  probe.frames(60);
  const [[x]] = probe.places();
  probe.simulator.dispose();
  return x < 3;
}

test('an object that was never in the scene is an anchor, one that leaves before the first step is not', () => {
  const smoke = new HandledSmoke(factory);
  smoke.emitFrom(new Object3D(), { rate: 60 });
  const object = smoke.put(new Object3D());
  smoke.emitFrom(object, { rate: 60 });
  smoke.scene.remove(object);
  smoke.frames(60);
  expect(smoke.simulator.alive).toBe(60);
  smoke.simulator.dispose();
});

test('a collider that returns elsewhere does not sweep smoke on its way', () => {
  const smoke = new HandledSmoke(factory);
  const ball = smoke.put(new Mesh(new SphereGeometry(1)), -5);
  const handle = smoke.collide(ball, { boundaryLayer: 1 });
  void smoke.pool.burst({ ...RESTING, position: { x: 0, y: 0, z: 0 }, count: 1 });
  smoke.frames(3);
  handle.enabled = false;
  smoke.frame();
  ball.position.x = 5;
  handle.enabled = true;
  smoke.frames(10);
  expect(smoke.places()).toEqual([[0, 0, 0]]);
  expect(smoke.simulator.rigidPoses(1)[0]).toBe(5);
  smoke.simulator.dispose();
});

test('errors name the option, and nothing is lost after them', () => {
  const smoke = new HandledSmoke(factory);
  const object = smoke.put(new Mesh(new BoxGeometry()));
  const emitter = smoke.emitFrom(object, { rate: 60 });
  const collider = smoke.collide(object);
  const bad = smoke.put(new Object3D());
  bad.position.x = NaN;
  const empty = new Mesh(new BoxGeometry());
  empty.geometry = null as never;
  const bare = new Mesh(new BoxGeometry());
  bare.geometry.deleteAttribute('position');
  const [at, count] = [{ x: 0, y: 0, z: 0 }, 3];
  const cases: [RegExp, () => unknown][] = [
    [
      /^emitFrom\.sped cannot be 3: it takes no value: its options are shape, /,
      () => smoke.emitFrom(object, { sped: 3 } as never),
    ],
    [/^emitFrom\.speed cannot be 51: it takes a number from 0 to 50/, () => smoke.emitFrom(object, { speed: 51 })],
    [/^emitFrom\.size cannot be NaN/, () => emitter.set({ size: NaN })],
    [
      /^emitFrom\.shape cannot be “surface”: it takes point, .*, line\.$/,
      () => emitter.set({ shape: 'surface' as never }),
    ],
    [/^emitFrom\.extent\.y cannot be NaN/, () => emitter.set({ extent: { x: 1, y: NaN, z: 1 } })],
    [/^emitFrom cannot be null/, () => emitter.set(null as never)],
    [/^emitFrom\.burst\.count cannot be 1\.5/, () => emitter.burst(1.5)],
    [/^emitFrom\.enabled cannot be “no”/, () => (emitter.enabled = 'no' as never)],
    [/^emitFrom\.object cannot be undefined: it takes an Object3D/, () => smoke.emitFrom(undefined as never)],
    [/^emitFrom\.object cannot be “Object3D at NaN, /, () => smoke.emitFrom(bad)],
    [/^emitter cannot be 8/, () => smoke.emitFrom(object, 8)],
    [/^emitFrom\.rate cannot be 4: .*emitters\.2\.share/, () => smoke.emitFrom(object, 2).set({ rate: 4 })],
    [/^burst\.positon cannot be/, () => smoke.pool.burst({ positon: at, count } as never)],
    [/^burst\.position cannot be undefined/, () => smoke.pool.burst({ count } as never)],
    [/^burst\.position\.z cannot be NaN/, () => smoke.pool.burst({ position: { x: 0, y: 0, z: NaN }, count })],
    [/^burst\.position cannot be “here”/, () => smoke.pool.burst({ position: 'here' as never, count })],
    [/^burst\.direction cannot be “0, 0, 0”/, () => smoke.pool.burst({ position: at, direction: at, count })],
    [/^burst\.count cannot be 0/, () => smoke.pool.burst({ position: at, count: 0 })],
    [/^burst\.count cannot be undefined/, () => smoke.pool.burst({ position: at } as never)],
    [
      /^burst\.tint cannot be 16: .*three colours that repeat/,
      () => smoke.pool.burst({ position: at, count, tint: 16 }),
    ],
    [/^collide\.bounce cannot be 1/, () => smoke.collide(object, { bounce: 1 } as never)],
    [/^collide\.tint cannot be 16: .*three colours that repeat/, () => smoke.collide(object, { tint: 16 })],
    [/^collide\.restitution cannot be NaN/, () => smoke.collide(object, { restitution: NaN })],
    [/^collide\.action cannot be “stick”/, () => smoke.collide(object, { action: 'stick' as never })],
    [/^collide\.object cannot be null/, () => smoke.collide(null as never)],
    [/^collide\.object cannot be “Object3D at NaN/, () => smoke.collide(bad.clone().add(new Mesh(new BoxGeometry())))],
    [/^collide\.geometry cannot be “Mesh”/, () => smoke.collide(empty)],
    [/^collide\.geometry cannot be “Mesh”/, () => smoke.collide(bare)],
    [
      /^collide\.proxies\.0\.radius cannot be NaN/,
      () => smoke.collide(object, { proxies: [{ follows: object, radius: NaN }] }),
    ],
    [/^attach cannot be “vortexes\.0”/, () => smoke.attach('vortexes.0', object)],
    [/^attach cannot be “colliders\.0”/, () => smoke.attach('colliders.0', object)],
    [/^attach\.object cannot be “Object3D at NaN/, () => smoke.attach('vortices.0', bad)],
  ];
  for (const [message, act] of cases) {
    expect(act, String(message)).toThrow(ParameterError);
    expect(act).toThrow(message);
  }
  emitter.remove();
  collider.remove();
  for (const act of [
    () => emitter.set({}),
    () => emitter.burst(1),
    () => (emitter.enabled = true),
    () => (collider.enabled = true),
  ]) {
    expect(act).toThrow(SimulatorError);
    expect(act).toThrow(/^(emitFrom|collide)\.(set|burst|enabled): this handle was removed; call \w+\(\) again\.$/);
  }
  const late = smoke.emitFrom(object, { rate: 60 });
  smoke.frames(60);
  expect(smoke.simulator.alive).toBe(60);
  expect(smoke.errors).toEqual([]);
  smoke.isAlive = false;
  expect(() => late.burst(1)).toThrow(/^emitFrom\.burst: the smoke of this handle was disposed/);
  late.remove();
  smoke.simulator.dispose();
});

test('a rejected mesh among many leaves no rigid behind', () => {
  const smoke = new HandledSmoke(factory);
  const group = smoke.put(new Group());
  group.add(new Mesh(new BoxGeometry()), new Mesh(new PlaneGeometry()));
  const bad = new Mesh(new BoxGeometry());
  bad.geometry.attributes.position.setX(0, NaN);
  group.add(bad);
  expect(() => smoke.collide(group)).toThrow(ParameterError);
  group.remove(bad);
  smoke.collide(group);
  smoke.collide(smoke.put(new Mesh(new BoxGeometry())));
  expect(smoke.simulator.rigidCount).toBe(3);
  smoke.simulator.dispose();
});

test('at most 128 objects emit at a time', () => {
  const smoke = new HandledSmoke(factory);
  const handles = Array.from({ length: 128 }, () => smoke.emitFrom(smoke.put(new Object3D())));
  expect(() => smoke.emitFrom(smoke.put(new Object3D()))).toThrow(/^emitFrom cannot be 129: it takes at most 128/);
  handles[50].remove();
  smoke.emitFrom(smoke.put(new Object3D()));
  smoke.frames(2);
  smoke.simulator.dispose();
});

test('a thousand adds and removes of each handle leave rigids and memory flat, and give the same hash', () => {
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc') as () => void;
  const run = () => {
    const smoke = new HandledSmoke(
      factory,
      { ...STILL, 'emission.rate': 60, 'emitters.0.share': 1, 'jets.0.speed': 1 },
      500,
    );
    const object = smoke.put(new Mesh(new BoxGeometry(1, 2, 3)));
    const sheet = smoke.put(new Mesh(new PlaneGeometry()), 4);
    let start = { heap: 0, wasm: 0 };
    const sizes = () => {
      // Otherwise the promises of bursts stay as long as their puffs.
      smoke.pool.resolve(() => true);
      collect();
      return { heap: process.memoryUsage().heapUsed, wasm: factory.module.memory.buffer.byteLength };
    };
    for (let round = 0; round < 1000; round++) {
      const handles = [
        smoke.emitFrom(object, { rate: 90 }),
        smoke.emitFrom(object, 0),
        smoke.collide(object),
        smoke.collide(sheet, { boundaryLayer: 0.5 }),
        smoke.attach('jets.0', object),
      ];
      void smoke.pool.burst({ position: object.position, count: 2 });
      object.position.x = (round % 10) / 10;
      if (round % 2) smoke.frame();
      for (const handle of handles) handle.remove();
      if (round === 200) start = sizes();
    }
    const end = sizes();
    smoke.frames(5);
    const { simulator } = smoke;
    expect(simulator.rigidCount).toBe(2);
    expect(simulator.rigidPoses(1)).toHaveLength(2 * POSE_FLOATS);
    expect(end.wasm).toBe(start.wasm);
    const hash = simulator.hash();
    simulator.dispose();
    return { hash, grown: end.heap - start.heap };
  };
  // The first runs compile the code, more of them on a busy machine. A handle that stayed would be 200 bytes in each run, five
  // of them 800,000 in all.
  const runs = [run(), run(), run(), run()];
  expect(new Set(runs.map(({ hash }) => hash)).size).toBe(1);
  expect(Math.min(...runs.map(({ grown }) => grown))).toBeLessThan(200_000);
});

test('the simulator rejects emitters that do not exist and numbers out of range', () => {
  const { simulator } = new HandledSmoke(factory);
  expect(() => simulator.setEmitter(392, new Float64Array(30), 1)).toThrow(/^emitter cannot be 392/);
  expect(() => simulator.setEmitter(8, new Float64Array(3))).toThrow(ParameterError);
  expect(() => simulator.setEmitter(9, new Float64Array(), 5)).toThrow(/^emitter cannot be 9/);
  simulator.dispose();
  expect(() => simulator.setEmitter(8, new Float64Array())).toThrow(SimulatorError);
});
