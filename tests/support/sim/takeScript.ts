/** Actions on a simulation of the lamp to record and replay, for Node and for pages. */
import { Vector3 } from 'three';
import { defaultPreset, presetValues } from '../../../src/parameters/presets.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { lamp } from '../../../src/scenes/lamp.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { Drag } from '../../../src/stage/drag.ts';
import { Simulation } from '../../../src/stage/simulation.ts';

export const VALUES: Values = { ...presetValues(defaultPreset), 'simulation.maxParticles': 300, 'emission.rate': 150 };
export const LAST_STEP = 400;

export function lampSimulation(factory: SimulatorFactory, historyBytes = 1e7): Simulation {
  return new Simulation(factory, lamp(), VALUES, historyBytes);
}

/** Actions before step `step`. */
export function act(simulation: Simulation, drag: Drag, step: number): void {
  if (step % 50 === 20) simulation.set({ 'forces.wind.x': step / 200 - 1 });
  if (step % 90 === 30) simulation.input((simulator) => simulator.inputCapacity(200 + step));
  if (step > 100 && step < 200) drag.moveTo(new Vector3(0.012 * (step - 100), 1.6, Math.sin(step / 9)));
  if (step === 200) drag.letGo();
  if (step % 40 === 5) {
    const blow = { origin: [0, 1.5, 6], ray: [0, 0, -1], velocity: [2, 0, -1], radius: 0.6, seconds: 0.7 };
    simulation.input((simulator) => simulator.inputBlow(blow));
  }
  if (step % 33 === 0) simulation.input((simulator) => simulator.inputSteer(step % 8, step / 400));
}

/** Runs the actions and returns the hashes after every 20th step. */
export function live(simulation: Simulation): string[] {
  const hashes: string[] = [];
  const drag = new Drag(simulation, lamp().handle!);
  for (let step = 0; step < LAST_STEP; ++step) {
    act(simulation, drag, step);
    simulation.advance(1);
    if ((step + 1) % 20 === 0) hashes.push(simulation.simulator.hash());
  }
  return hashes;
}

/** The hashes at the same steps of a replay. */
export function follow(simulation: Simulation): string[] {
  const hashes: string[] = [];
  for (let step = 20; step <= LAST_STEP; step += 20) {
    simulation.advance(20);
    hashes.push(simulation.simulator.hash());
  }
  return hashes;
}
