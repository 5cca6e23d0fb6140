/** The airplane of Fig. 2: the swirl of its propeller, wing-tip vortices, hull, and steering. */
import { Quaternion, Vector3 } from 'three';
import { beforeAll, describe, expect, test } from 'vitest';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { AIRSPEED, airplane, PROPELLER_SENSE } from '../../../src/scenes/airplane.ts';
import { airplaneHull, HALF_SPAN, HUB, PROPELLER } from '../../../src/scenes/models/airplane.ts';
import { placement } from '../../../src/scenes/models/place.ts';
import type { Scene } from '../../../src/scenes/scene.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import type { RigidPart } from '../../../src/simulator/rigid.ts';
import type { Simulator } from '../../../src/simulator/simulator.ts';
import { Drag } from '../../../src/stage/drag.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const STEPS_A_SECOND = 60;
let factory: SimulatorFactory;
let scene: Scene;

beforeAll(async () => {
  factory = await loadVariant('physics');
  scene = airplane();
});

/** Tracers in the wind around one shedder, which is attached to a negligibly small rigid. */
function tracers(shedder: number, values: Record<string, number>): Simulator {
  const simulator = factory.create({ capacity: 20_000, seed: 3 });
  const shedders = Object.entries(scene.rig).filter(([key]) => key.startsWith('shedders'));
  const others = shedders.filter(([key]) => key.endsWith('.rate') && !key.startsWith(`shedders.${shedder}`));
  simulator.addRigid({ kind: 'kinematic', shape: { type: 'ball', radius: 0.01 }, position: [0, 0, 0] });
  simulator.set({
    ...Object.fromEntries(shedders),
    ...Object.fromEntries(others.map(([key]) => [key, 0])),
    'winds.0.velocity.x': -AIRSPEED,
    'emission.rate': 3000,
    'emission.lifetime': 4,
    'emission.growthTime': 0,
    'emitters.0.shape': 1,
    'emitters.0.direction.x': -1,
    'emitters.0.direction.y': 0,
    'emitters.0.speed': 0,
    'emitters.0.size': 0.01,
    'emitters.0.temperature': 0,
    'emitters.0.share': 1,
    'turbulence.octaves': 0,
    ...values,
  });
  return simulator;
}

describe('the slipstream of the propeller', () => {
  test('rotates with the propeller in free air, and decays', () => {
    const simulator = tracers(0, {
      'emitters.0.position.x': HUB[0] + 0.5,
      'emitters.0.radius': 0.6,
      'emission.lifetime': 2.5,
    });
    simulator.step(240);
    const sense = senseOfPropeller();
    const [before, behind, later, far] = [
      [0.2, 0.5],
      [-1, -0.3],
      [-3.4, -2.7],
      [-6, -5],
    ].map(([low, high]) => sense * angularRate(simulator, HUB[0] + low, HUB[0] + high));
    expect(behind).toBeGreaterThan(1);
    expect(before).toBeLessThan(0.5 * behind);
    expect(later).toBeLessThan(0.75 * behind);
    expect(later).toBeGreaterThan(0);
    expect(Math.abs(far)).toBeLessThan(0.4 * behind);
    simulator.dispose();
  });

  /** Around +x. */
  function senseOfPropeller(): number {
    const { pose } = scene.parts![PROPELLER];
    const blade = (seconds: number) => new Vector3(0, 1, 0).applyQuaternion(new Quaternion(...pose(seconds).rotation));
    const sense = Math.sign(blade(0).cross(blade(0.01)).x);
    expect(sense).toBe(PROPELLER_SENSE);
    return sense;
  }

  /** Mean angular velocity around the hub's axis of the tracers between two positions along it, rad/s. */
  function angularRate(simulator: Simulator, low: number, high: number): number {
    const { x, y, z, py, pz } = readParticles(simulator);
    const rates: number[] = [];
    x.forEach((along, i) => {
      const [ry, rz] = [y[i] - HUB[1], z[i] - HUB[2]];
      const squared = ry * ry + rz * rz;
      if (along < low || along > high || squared < 0.01 || squared > 0.36) return;
      rates.push((STEPS_A_SECOND * (ry * (z[i] - pz[i]) - rz * (y[i] - py[i]))) / squared);
    });
    expect(rates.length).toBeGreaterThan(50);
    return rates.reduce((sum, rate) => sum + rate, 0) / rates.length;
  }
});

test('the wingtip vortices are proportional to the speed of flight', () => {
  const share = scene.rig['shedders.1.perSpeed'];
  const fastest = [AIRSPEED, 2 * AIRSPEED].map((speed) => {
    // Few enough not to interact, shed at even distances.
    const simulator = tracers(1, {
      'winds.0.velocity.x': -speed,
      'shedders.1.rate': speed,
      'shedders.1.jitter': 0,
      'emitters.0.position.x': 0.5,
      'emitters.0.position.y': scene.rig['shedders.1.position.y'],
      'emitters.0.position.z': HALF_SPAN,
      'emitters.0.radius': 0.5,
      'emission.lifetime': 0.4,
    });
    simulator.step(60);
    let most = 0;
    for (let step = 0; step < 120; step++) {
      simulator.step();
      const { y, z, py, pz } = readParticles(simulator);
      y.forEach((_, i) => (most = Math.max(most, STEPS_A_SECOND * Math.hypot(y[i] - py[i], z[i] - pz[i]))));
    }
    simulator.dispose();
    return most;
  });
  expect(fastest[0]).toBeGreaterThan(0.85 * share * AIRSPEED);
  expect(fastest[0]).toBeLessThan(1.1 * share * AIRSPEED);
  expect(fastest[1] / fastest[0]).toBeGreaterThan(1.85);
  expect(fastest[1] / fastest[0]).toBeLessThan(2.15);
});

describe('in flight', () => {
  const { min, max } = airplane().handle!;
  const begin = () => new Simulation(factory, scene, presetValues(findPreset('airplane')!), 1e6);
  const corners = [min, max, [max[0], min[1], max[2]], [min[0], max[1], min[2]]] as const;

  test('no particle enters the hull, wherever it is steered', () => {
    const ghost = { ...scene.rigids[0], shape: { type: 'ball', radius: 0.01 }, boundaryLayer: 0 } as const;
    const [hull, none] = [scene, { ...scene, rigids: [ghost] }].map(deepestIn);
    expect(hull).toBeLessThan(1e-3);
    // Control: the same flight through the same smoke without collisions.
    expect(none).toBeGreaterThan(0.15);
  });

  test('clouds rotate with the propeller, beside it and behind the tail', () => {
    const [inverse, still] = [true, false].map((hasSlipstream) => {
      const flights = [1, 2, 3, 4].map((seed) => cloudsInFlight(seed, hasSlipstream));
      return { beside: meanSwirl(flights, 'beside'), behind: meanSwirl(flights, 'behind') };
    });
    expect(PROPELLER_SENSE * inverse.beside).toBeGreaterThan(0.35);
    expect(PROPELLER_SENSE * inverse.behind).toBeGreaterThan(0.9);
    // Hull and wing vortices alone do not rotate the clouds to either side.
    expect(Math.abs(still.beside)).toBeLessThan(0.05);
    expect(Math.abs(still.behind)).toBeLessThan(0.2);
  });

  test('in the look Corkscrew the part Propeller sheds the vortex that turns the smoke behind the tail', () => {
    const elsewhere = { ...scene.parts![PROPELLER], pose: () => placement([0, 40, 0]) };
    const [shed, without] = [scene, { ...scene, parts: [elsewhere] }].map((flown) => {
      const values = presetValues(findPreset('airplane-corkscrew')!);
      return meanSwirl([swirlIn(new Simulation(factory, flown, values, 1e6), 480)], 'behind');
    });
    expect(PROPELLER_SENSE * shed).toBeGreaterThan(0.9);
    expect(Math.abs(without)).toBeLessThan(0.2);
  });

  /** Mean speeds at which clouds move around the propeller axis, m/s, positive around the nose direction. */
  interface Swirl {
    /** Between the propeller and the leading edge of the wings, and behind the tail. */
    beside: number[];
    behind: number[];
  }

  /** Twenty seconds of the preset, with the rendered hull and clouds. */
  function cloudsInFlight(seed: number, hasSlipstream: boolean): Swirl {
    const simulation = new Simulation(factory, scene, { ...presetValues(findPreset('airplane')!), seed }, 1e6);
    if (!hasSlipstream) simulation.simulator.set({ 'shedders.0.rate': 0 });
    return swirlIn(simulation, 1200);
  }

  function swirlIn(simulation: Simulation, steps: number): Swirl {
    const swirl: Swirl = { beside: [], behind: [] };
    for (let step = 0; step < steps; step++) {
      simulation.advance(1);
      if (step >= 240 && step % 5 === 0) addSwirl(simulation.simulator, swirl);
    }
    simulation.dispose();
    return swirl;
  }

  function addSwirl(simulator: Simulator, { beside, behind }: Swirl): void {
    const pose = simulator.rigidPoses(1);
    const inverse = new Quaternion(...pose.subarray(3, 7)).invert();
    const { x, y, z, px, py, pz } = readParticles(simulator);
    x.forEach((_, i) => {
      const place = new Vector3(x[i] - pose[0], y[i] - pose[1], z[i] - pose[2]).applyQuaternion(inverse);
      const [along, up, aside] = place.toArray().map((value, axis) => value - HUB[axis]);
      const radius = Math.hypot(up, aside);
      if (radius < 0.1 || radius > 1.2) return;
      const way = new Vector3(x[i] - px[i], y[i] - py[i], z[i] - pz[i]).applyQuaternion(inverse);
      const speed = (STEPS_A_SECOND * (up * way.z - aside * way.y)) / radius;
      if (along > 0 && along < 0.6) beside.push(speed);
      if (along > -7 && along < -2.5) behind.push(speed);
    });
  }

  function meanSwirl(flights: readonly Swirl[], where: keyof Swirl): number {
    const speeds = flights.flatMap((flight) => flight[where]);
    expect(speeds.length).toBeGreaterThan(100);
    return speeds.reduce((sum, speed) => sum + speed, 0) / speeds.length;
  }

  /** Largest depth of smoke inside the hull, metres; negative outside. */
  function deepestIn(flown: Scene): number {
    const values = { ...presetValues(findPreset('airplane')!), 'emission.rate': 500, 'simulation.maxParticles': 5000 };
    const simulation = new Simulation(factory, flown, values, 1e6);
    // Without the repulsion that moves smoke away before it touches the hull.
    simulation.simulator.set({ 'attractors.0.acceleration': 0 });
    let deepest = -Infinity;
    for (let step = 0; step < 600; step++) {
      if (step % 150 === 60) steer(simulation, corners[(step - 60) / 150]);
      simulation.advance(1);
      if (step % 6 === 0) deepest = Math.max(deepest, depthOf(simulation.simulator));
    }
    simulation.dispose();
    return deepest;
  }

  test('it flies where it is steered, banks in turns and moves continuously', () => {
    const simulation = begin();
    simulation.advance(60);
    let before = Float32Array.from(simulation.simulator.rigidPoses(1));
    steer(simulation, max);
    let roll = 0;
    for (let step = 0; step < 420; step++) {
      simulation.advance(1);
      const pose = Float32Array.from(simulation.simulator.rigidPoses(1));
      const way = Math.hypot(...[0, 1, 2].map((axis) => pose[axis] - before[axis]));
      expect(way).toBeLessThan(0.08);
      const quaternion = new Quaternion(...pose.subarray(3));
      roll = Math.max(roll, new Vector3(0, 0, 1).applyQuaternion(quaternion).y * -1);
      before = pose;
    }
    expect(roll).toBeGreaterThan(0.2);
    // It bobs around the position.
    [0.02, 0.35, 0.33].forEach((bob, axis) => expect(Math.abs(before[axis] - max[axis])).toBeLessThan(bob + 0.05));
    simulation.dispose();
  });

  function steer(simulation: Simulation, place: readonly number[]): void {
    new Drag(simulation, simulation.scene.handle!).moveTo(new Vector3(...place));
  }
});

/** Depth of the deepest particle inside the hull, metres. */
function depthOf(simulator: Simulator): number {
  const pose = simulator.rigidPoses(1);
  const inverse = new Quaternion(...pose.subarray(3, 7)).invert();
  const hull = airplaneHull();
  const parts = hull.type === 'compound' ? hull.parts : [];
  expect(parts.length).toBeGreaterThan(2);
  const { x, y, z } = readParticles(simulator);
  const depths = Array.from(x, (_, i) => {
    const place = new Vector3(x[i] - pose[0], y[i] - pose[1], z[i] - pose[2]);
    // No part of the hull is farther away.
    if (place.length() > 1.8) return -Infinity;
    return Math.max(...parts.map((part) => depthIn(part, place.clone().applyQuaternion(inverse))));
  });
  return depths.reduce((most, depth) => Math.max(most, depth), -Infinity);
}

/** Metres below the surface of a capsule or a cuboid; negative outside. */
function depthIn({ shape, position, rotation }: RigidPart, place: Vector3): number {
  const local = place.clone().sub(new Vector3(position[0], position[1], position[2]));
  if (rotation) local.applyQuaternion(new Quaternion(rotation[0], rotation[1], rotation[2], rotation[3]).invert());
  if (shape.type === 'capsule') {
    const along = Math.max(0, Math.abs(local.y) - shape.halfHeight);
    return shape.radius - Math.hypot(local.x, along, local.z);
  }
  if (shape.type !== 'cuboid') throw new Error(`A ${shape.type} is not expected.`);
  return Math.min(...[0, 1, 2].map((axis) => shape.halfExtents[axis] - Math.abs(local.getComponent(axis))));
}
