/** Flows in smoke of a three.js scene. */
import { Object3D } from 'three';
import type { Values } from '../../../../src/parameters/parameter.ts';
import { CartoonSmoke } from '../../../../src/three/cartoonSmoke.ts';
import { EVERYTHING } from '../../../support/sim/everything.ts';
import { emptyHost, HANGING, type Host } from '../scene.ts';

const FLOW: Values = { 'flows.0.speed': 2, 'flows.0.points': '0:-1:0,.6:0:.1,-.4:1:-.2,.2:2:0', 'flows.0.radius': 0.6 };
const LANE = '120;flows.0.speed/0*0/60*3;flows.0.points/0*0:-1:0,1:1:0/60*0:-1:0,-1:1:.5';

const make = ({ renderer, keyLight }: Host, values: Values, physics?: boolean): Promise<CartoonSmoke> =>
  CartoonSmoke.create({ renderer, keyLight, values: { ...HANGING, ...values }, physics });

/** Whether steps wait, and hashes after 120 steps: with a flow from step 20 on, and with a timeline. */
export async function hashes(): Promise<{ steps: number[]; flows: string[]; lanes: string[] }> {
  const host = emptyHost();
  const late = await make(host, {});
  const lane = await make(host, {});
  late.step(20);
  late.set(FLOW);
  late.step(100);
  late.update(0);
  late.update(0.05);
  const steps = [late.stats.steps];
  lane.set({ timeline: LANE });
  lane.step(120);
  await Promise.all([late.complete(), lane.complete()]);
  steps.push(late.stats.steps);
  const loaded = await make(host, { 'flows.3.speed': 0 });
  loaded.step(20);
  loaded.set(FLOW);
  loaded.step(100);
  const restored = await make(host, {});
  restored.restore(late.save());
  const created = await make(host, { timeline: LANE });
  created.step(120);
  const all = [late, loaded, restored, lane, created];
  const found = all.map((smoke) => smoke.hash());
  for (const smoke of all) smoke.dispose();
  host.renderer.dispose();
  return { steps, flows: found.slice(0, 3), lanes: found.slice(3) };
}

/** How much faster smoke rises in a flow that rides on an object above it; the errors without larger simulators. */
export async function riding(): Promise<{ heights: number[]; errors: string[] }> {
  const host = emptyHost();
  const values: Values = { 'flows.0.speed': 3, 'flows.0.radius': 0.8, 'flows.0.scale': 3 };
  const heights: number[] = [];
  for (const height of [50, -1]) {
    const smoke = await make(host, values);
    const object = new Object3D();
    object.position.y = height;
    smoke.attach('flows.0', object);
    smoke.step(90);
    const { count, place } = smoke['simulator'].arrange(EVERYTHING).rows;
    heights.push(Math.max(...Array.from({ length: count }, (_, row) => place[4 * row + 1])));
    smoke.dispose();
  }
  const errors: string[] = [];
  await make(host, values, false).catch((error: Error) => errors.push(error.name));
  const small = await make(host, {}, false);
  try {
    small.set(values);
  } catch (error) {
    errors.push((error as Error).name);
  }
  errors.push(String('flows.0.speed' in small.get()));
  small.dispose();
  host.renderer.dispose();
  return { heights, errors };
}
