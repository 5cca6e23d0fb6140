/** Stages that get their first flow late, in each way. */
import type { Values } from '../../../src/parameters/parameter.ts';
import { openStage } from '../../../src/stage/remote/openStage.ts';
import { createStage, type Stage } from '../../../src/stage/stage.ts';
import { PLAIN_LOOK } from '../../support/plainLook.ts';

const FLOW: Values = { 'flows.0.speed': 2, 'flows.0.points': '0:.2:0,.4:.9:.1,-.3:1.6:-.2' };
const LANE = '120;flows.0.speed/0*2/60*3';
const SIZE = { width: 80, height: 60 };
const VALUES: Values = { ...PLAIN_LOOK, scene: 'wisp', 'simulation.maxParticles': 300, 'puff.variations': 1 };

const open = (values = VALUES): Promise<Stage> => createStage(document.createElement('canvas'), { values, ...SIZE });

/** Whether steps wait for the simulator, and the hashes after 120 steps with a flow from step 20 on, the first one before it is loaded. */
export async function hashes(): Promise<{ steps: number[]; hashes: string[] }> {
  const late = await open();
  late.step(20);
  late.set(FLOW);
  late.step(40);
  late.advance(1);
  const steps = [late.stats.steps];
  await late.complete();
  steps.push(late.stats.steps);
  const loaded = await open();
  loaded.step(20);
  loaded.set(FLOW);
  loaded.step(100);
  const replayed = await open();
  replayed.playTake(late.take());
  await replayed.seek(2);
  const copy = await loaded.copy(document.createElement('canvas'), SIZE);
  const stages = [late, loaded, replayed, copy];
  const found = stages.map((stage) => stage.hash());
  for (const stage of stages) stage.dispose();
  return { steps, hashes: found };
}

/** The hash after 100 steps of a stage that gets a flow and a timeline. */
export async function remote(thread: 'main' | 'worker'): Promise<string> {
  const canvas = document.createElement('canvas');
  document.body.append(canvas);
  const stage = await openStage(() => canvas, { values: VALUES, ...SIZE, thread });
  await stage.set({ ...FLOW, timeline: LANE });
  await stage.step(100);
  const hash = await stage.hash();
  await stage.dispose();
  canvas.remove();
  return hash;
}

/** The errors of a stage whose simulator cannot be loaded, and its steps. */
export async function failing(): Promise<{ errors: string[]; steps: number[] }> {
  const stage = await open();
  const errors: string[] = [];
  stage.on('error', (error) => errors.push(error.name));
  stage.set(FLOW);
  stage.step(5);
  const steps = [stage.stats.steps];
  await stage.complete().catch(() => undefined);
  steps.push(stage.stats.steps);
  stage.dispose();
  return { errors, steps };
}
