/** Models in a scene, whose state must be the same in Node and in every browser. */
import { finished } from '../../../src/base/work.ts';
import { defaults } from '../../../src/parameters/values.ts';
import { air } from '../../../src/scenes/air.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { openModel } from '../../../src/stage/model/stageModel.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { bendingColumn, turningBox } from '../files/glb.ts';

const FILES = { turningBox, bendingColumn };
const STEPS = 240;

/** The hashes after four seconds of smoke that rides on a node of each model and collides with the model. */
export const MODEL_HASHES: Readonly<Record<keyof typeof FILES, string>> = {
  turningBox: '60ba358d2f769c6a',
  bendingColumn: 'aa002cc5b5dea091',
};

/** @param factory with meshes */
export async function modelHashes(factory: SimulatorFactory): Promise<Record<string, string>> {
  const hashes: Record<string, string> = {};
  for (const [name, make] of Object.entries(FILES)) {
    const add = await openModel(make().pack(), {
      size: 1.7,
      turn: 0.3,
      speed: 0.9,
      position: { x: 0.1, y: -1, z: 0 },
    });
    const { scene, model } = finished(add(air()));
    const rider = { 'emitters.1.share': 1, 'emitters.1.rigid': model.model.nodes[1].rigid, 'emitters.1.position.y': 1 };
    const simulation = new Simulation(factory, scene, { ...defaults(), scene: 'air', ...rider });
    simulation.advance(STEPS);
    hashes[name] = simulation.simulator.hash();
    simulation.dispose();
  }
  return hashes;
}
