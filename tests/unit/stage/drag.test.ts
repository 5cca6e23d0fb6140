/** The lamp's ball, dragged on its spring by pointer and keys. */
import { PerspectiveCamera, Vector2, Vector3 } from 'three';
import { beforeAll, describe, expect, it } from 'vitest';
import { lamp } from '../../../src/scenes/lamp.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { Drag } from '../../../src/stage/drag.ts';
import type { Simulation } from '../../../src/stage/simulation.ts';
import { lampSimulation, VALUES } from '../../support/sim/takeScript.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const { radius, start, min, max } = lamp().handle!;
const START = new Vector3(...start);
const STIFFNESS_TIMES_STEP = 30 / 60;

let factory: SimulatorFactory;
beforeAll(async () => {
  factory = await loadVariant('physics');
});

const camera = new PerspectiveCamera(40, 1.6, 0.05, 200);
camera.position.set(0, 1.6, 6);
camera.updateMatrixWorld();

/** A world position on the screen. */
function seen(place: Vector3): Vector2 {
  const { x, y } = place.clone().project(camera);
  return new Vector2(x, y);
}

function ball(simulation: Simulation): Vector3 {
  return new Vector3().fromArray(simulation.simulator.rigidPoses(1));
}

function begin(): { simulation: Simulation; drag: Drag } {
  const simulation = lampSimulation(factory);
  simulation.rigids(1);
  return { simulation, drag: new Drag(simulation, lamp().handle!) };
}

function grabAt(drag: Drag, place: Vector3): boolean {
  return drag.grab(1, seen(place), camera);
}

function follow(drag: Drag, at: Vector2): void {
  expect(drag.movePointer(1, at, camera)).toBe(true);
}

function letGo(drag: Drag): void {
  expect(drag.release(1)).toBe(true);
}

/** The share of the distance that remains `steps` steps after a start at rest. */
function left(steps: number): number {
  const a = STIFFNESS_TIMES_STEP;
  return (1 + (steps * a) / (1 + a)) / (1 + a) ** steps;
}

describe('the pointer', () => {
  it('pulls the point that it hit towards itself by the law of the spring', () => {
    const { simulation, drag } = begin();
    expect(grabAt(drag, START.clone().add(new Vector3(0.1, 0.12, 0)))).toBe(true);
    const { anchor, target } = drag;
    expect(Math.abs(anchor.length() - radius), 'on the surface').toBeLessThan(0.001);
    const at = seen(new Vector3(-0.4, 2.2, 0));
    follow(drag, at);
    const way = target.distanceTo(START);
    expect(way).toBeGreaterThan(1);
    for (let step = 1; step <= 40; ++step) {
      simulation.advance(1);
      expect(Math.abs(ball(simulation).distanceTo(target) - way * left(step)), `step ${step}`).toBeLessThan(0.001);
    }
    expect(seen(ball(simulation).add(anchor)).distanceTo(at), 'what was hit is under the pointer').toBeLessThan(0.002);
    simulation.dispose();
  });

  it('never pulls the ball out of its box', () => {
    const { simulation, drag } = begin();
    const [low, high] = [new Vector3(...min), new Vector3(...max)];
    grabAt(drag, START.clone().add(new Vector3(-0.13, 0.07, 0)));
    const reached = [new Vector3().copy(START), new Vector3().copy(START)];
    for (let step = 0; step < 240; ++step) {
      follow(drag, new Vector2(3 * Math.sin(step / 19), 3 * Math.cos(step / 7)));
      simulation.advance(1);
      reached[0].min(ball(simulation));
      reached[1].max(ball(simulation));
    }
    for (const axis of ['x', 'y'] as const) {
      expect(reached[0][axis]).toBeGreaterThanOrEqual(low[axis] - 1e-6);
      expect(reached[1][axis]).toBeLessThanOrEqual(high[axis] + 1e-6);
      expect(reached[1][axis] - reached[0][axis]).toBeGreaterThan(0.8 * (high[axis] - low[axis]));
    }
    simulation.dispose();
  });

  it('leaves the ball where it was released, also while paused', () => {
    const { simulation, drag } = begin();
    grabAt(drag, START);
    follow(drag, seen(new Vector3(0.9, 2, 0)));
    letGo(drag);
    simulation.advance(30);
    expect(simulation.simulator.inputCount, 'still held').toBe(1);
    simulation.advance(1);
    expect(simulation.simulator.inputCount, 'let go').toBe(2);
    const settled = ball(simulation);
    expect(settled.distanceTo(drag.target)).toBeLessThan(0.001);
    simulation.advance(30);
    expect(ball(simulation)).toEqual(settled);
    simulation.dispose();
  });

  it('changes nothing on a click', () => {
    const { simulation, drag } = begin();
    const still = lampSimulation(factory);
    expect(grabAt(drag, START)).toBe(true);
    letGo(drag);
    expect(grabAt(drag, new Vector3(-1, 1, 0)), 'beside the ball').toBe(false);
    for (const each of [simulation, still]) each.advance(60);
    expect(simulation.simulator.inputCount).toBe(0);
    expect(simulation.simulator.hash()).toBe(still.simulator.hash());
    for (const each of [simulation, still]) each.dispose();
  });

  it('repeats a drag in a take', () => {
    const { simulation: first, drag } = begin();
    const second = lampSimulation(factory);
    const hashes: string[] = [];
    grabAt(drag, START.clone().add(new Vector3(0.05, -0.1, 0)));
    for (let step = 0; step < 120; ++step) {
      if (step < 50) follow(drag, new Vector2(0.4 - step / 60, Math.sin(step / 8) / 3));
      if (step === 50) letGo(drag);
      first.advance(1);
      hashes.push(first.simulator.hash());
    }
    second.replay(first.simulator.take(), VALUES);
    for (const [step, hash] of hashes.entries()) {
      second.advance(1);
      expect(second.simulator.hash(), `step ${step + 1}`).toBe(hash);
    }
    expect(ball(first).distanceTo(START)).toBeGreaterThan(0.5);
    for (const each of [first, second]) each.dispose();
  });
});

it('a nudge moves the ball smoothly', () => {
  const { simulation, drag } = begin();
  drag.nudge(new Vector3(-0.5, 0.2, 0.1));
  const goal = START.clone().add(new Vector3(-0.5, 0.2, 0.1));
  for (let step = 1; step <= 35; ++step) {
    simulation.advance(1);
    const expected = goal.distanceTo(START) * left(Math.min(step, 30));
    expect(Math.abs(ball(simulation).distanceTo(goal) - expected), `step ${step}`).toBeLessThan(0.0005);
  }
  simulation.dispose();
});
