import { BoxGeometry, CylinderGeometry, Group, Mesh, SphereGeometry } from 'three';
import { beforeAll, expect, test } from 'vitest';
import { ParameterError } from '../../../src/base/errors.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { HandledSmoke, STILL } from '../../support/handledSmoke.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

let factory: SimulatorFactory;
beforeAll(async () => {
  factory = await loadVariant('physics');
});

test('an object that feels smoke falls onto a collider and rests there; without the option it stays', () => {
  const smoke = new HandledSmoke(factory);
  const floor = smoke.put(new Mesh(new BoxGeometry(6, 1, 6)));
  const ball = smoke.put(new Mesh(new SphereGeometry(0.2)));
  const still = smoke.put(new Mesh(new SphereGeometry(0.2)), 2);
  ball.position.y = still.position.y = 2;
  smoke.collide(floor);
  smoke.collide(ball, { feelsSmoke: true });
  smoke.collide(still, { feelsSmoke: false });
  smoke.frames(20);
  // A free fall, by Rapier's four parts of a step of 1/60 s.
  expect(ball.position.y).toBeCloseTo(2 - (9.81 / 240 ** 2) * ((80 * 81) / 2), 3);
  smoke.frames(120);
  expect(ball.position.y).toBeCloseTo(0.7, 2);
  expect(still.position.y).toBe(2);
  smoke.simulator.dispose();
});

test('a jet of smoke lifts a light lantern and not a heavy one', () => {
  const lift = (density: number) => {
    const smoke = new HandledSmoke(factory, {
      ...STILL,
      'jets.0.speed': 14,
      'jets.0.radius': 2,
      'jets.0.reach': 30,
      'jets.0.direction.y': 1,
      'jets.0.direction.x': 0,
    });
    const lantern = smoke.put(new Group());
    lantern.add(new Mesh(new CylinderGeometry(0.3, 0.3, 0.6)));
    lantern.position.y = 2;
    smoke.collide(lantern, { feelsSmoke: true, density });
    smoke.emitFrom(smoke.put(new Mesh()), {
      shape: 'disc',
      radius: 0.6,
      rate: 900,
      size: 0.15,
      speed: 8,
      lifetime: 0.05,
    });
    smoke.frames(60);
    smoke.simulator.dispose();
    return lantern.position.y;
  };
  const [light, heavy] = [lift(0.5), lift(500)];
  expect(heavy).toBeLessThan(-2);
  expect(light).toBeGreaterThan(heavy + 1);
});

test('its parent and its scale are kept, a move by the host is a move of the rigid, and it pauses', () => {
  const smoke = new HandledSmoke(factory);
  const parent = smoke.put(new Group(), 5);
  parent.rotation.y = 1;
  parent.scale.setScalar(2);
  const box = new Mesh(new BoxGeometry());
  box.position.set(1, 3, 0);
  box.scale.set(0.1, 0.2, 0.3);
  parent.add(box);
  const handle = smoke.collide(box, { feelsSmoke: 0.5 });
  const before = box.getWorldPosition(box.position.clone());
  smoke.frames(10);
  const after = box.getWorldPosition(box.position.clone());
  expect(after.x).toBeCloseTo(before.x, 4);
  expect(after.z).toBeCloseTo(before.z, 4);
  expect(after.y).toBeLessThan(before.y - 0.05);
  expect(box.scale.toArray().map((part) => Number(part.toFixed(5)))).toEqual([0.1, 0.2, 0.3]);
  box.position.set(0, 10, 0);
  smoke.frame();
  expect(box.getWorldPosition(after).y).toBeCloseTo(20, 1);
  handle.enabled = false;
  smoke.frame();
  const { y } = box.position;
  smoke.frames(10);
  expect(box.position.y).toBe(y);
  handle.enabled = true;
  smoke.frames(10);
  expect(box.position.y).toBeLessThan(y);
  handle.remove();
  expect(smoke.errors).toEqual([]);
  smoke.simulator.dispose();
});

test('errors name the option', () => {
  const smoke = new HandledSmoke(factory);
  const box = smoke.put(new Mesh(new BoxGeometry()));
  const cases: [RegExp, () => unknown][] = [
    [
      /^collide\.feelsSmoke cannot be 11: it takes true, false or a number from 0 to 10/,
      () => smoke.collide(box, { feelsSmoke: 11 }),
    ],
    [/^collide\.feelsSmoke cannot be NaN/, () => smoke.collide(box, { feelsSmoke: NaN })],
    [/^collide\.density cannot be 0/, () => smoke.collide(box, { feelsSmoke: true, density: 0 })],
    [
      /^collide\.proxies cannot be “proxies”/,
      () => smoke.collide(box, { feelsSmoke: true, proxies: [{ follows: box, radius: 1 }] }),
    ],
    [/^collide cannot be “Group”/, () => smoke.collide(new Group(), { feelsSmoke: true })],
  ];
  for (const [message, act] of cases) {
    expect(act).toThrow(ParameterError);
    expect(act).toThrow(message);
  }
  expect(smoke.simulator.rigidCount).toBe(0);
  smoke.simulator.dispose();
});
