/** A timeline with each kind of parameter, played, sought and replayed, for Node and for pages. */
import type { Values } from '../../../src/parameters/parameter.ts';
import { presetValues } from '../../../src/parameters/presets.ts';
import { readTimeline, valueAt } from '../../../src/parameters/timeline.ts';
import { fetchTimelineText } from '../../../src/renderer/extraPasses.ts';
import { wisp } from '../../../src/scenes/wisp.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { Simulation } from '../../../src/stage/simulation.ts';

/** Numbers, whole numbers, vectors, directions, choices, curves, ramps, colours and toggles; each easing; a loop. */
export const TIMELINE = [
  '173*loop',
  'emission.rate/0*37/41*260*e/97*61.7*.31,-1.7,.62,2.9/160*90.1',
  'emission.lifetime/5*2.1*i/77*4.3*o/150*1.37',
  'emission.density/0*0:1,.413:.7,1:0/120*0:.3,.77:1,1:.1',
  'turbulence.octaves/0*1/60*4*h/120*2',
  'turbulence.speed/0*.1*e/90*1.3',
  'forces.wind.x/10*-1.1*.9,.03,.11,.97/80*2.3*o/170*0',
  'emitters.0.position.y/0*0/86*.71*i/172*.1',
  'emitters.0.direction.x/0*-1/172*1',
  'emitters.0.shape/0*disc/50*ring/100*point',
  'emitters.0.tint/0*0/100*3',
  'vortices.0.circulation/30*0/90*1.7*e/140*-1.3',
  'puff.size/0*.7/100*1.3*e',
  'style.smokeColor/0*ffffff/60*123456*e/120*fedcba',
  'style.ramp/0*0:333344,.5:aab0c0,1:ffffff*e/120*0:000000,.25:8899aa,.9:123456',
  'style.outlines/0*1/90*0',
  'light.azimuth/0*-170/172*170',
  'camera.distance/0*6/60*3*.1,.9,.2,1/172*6',
  'burst/20*0*40/130*0*17',
].join(';');

const VALUES: Values = { ...presetValues('wisp'), 'simulation.maxParticles': 900, timeline: TIMELINE };
const STEPS = 420;
/** The hash after these steps, in every engine. */
export const TIMELINE_HASH = '02d67f6c646f3db2';

/** Changes by a person before steps, at keyframes and between them. */
const BY_HAND: Readonly<Record<number, Values>> = {
  41: { 'emission.rate': 300.3 },
  133: { 'forces.wind.x': 0.77, 'emitters.0.tint': 5, 'puff.size': 0.9 },
  301: { 'emission.density': '0:0,.5:1,1:0', 'turbulence.octaves': 3 },
};

/** Hashes after 420 steps: played, sought in both directions, continued from a saved state, and replayed. */
export async function timelineHashes(factory: SimulatorFactory): Promise<Record<string, string>> {
  const { timeline = '' } = await fetchTimelineText({ timeline: TIMELINE });
  const simulation = new Simulation(factory, wisp(), { ...VALUES, timeline }, 1e7);
  let state: Uint8Array | undefined;
  while (simulation.simulator.steps < STEPS) {
    const { steps } = simulation.simulator;
    const changed = BY_HAND[steps];
    if (changed) {
      simulation.set(changed);
      simulation.record({ ...changed }, steps);
    }
    if (steps === 133) state = simulation.save(VALUES);
    simulation.advance(1);
  }
  const played = simulation.simulator.hash();
  const take = simulation.take();
  for (const goal of [77, 400, 12, STEPS]) {
    simulation.approach(goal);
    simulation.advance(goal - simulation.simulator.steps);
  }
  const sought = simulation.simulator.hash();
  const replay = new Simulation(factory, wisp(), { ...VALUES, timeline: '' }, 0);
  replay.playTake(take);
  replay.advance(STEPS);
  const replayed = replay.simulator.hash();
  replay.playTake(take);
  replay.rewind(state!);
  replay.advance(STEPS - 133);
  const continued = replay.simulator.hash();
  for (const each of [simulation, replay]) each.dispose();
  return { played, sought, replayed, continued };
}

/** The values of all lanes between steps, as text. */
export function timelineValues(): string {
  const { lanes } = readTimeline(TIMELINE).timeline;
  const times = Array.from({ length: 500 }, (_, index) => index * 0.347);
  return JSON.stringify(lanes.map((lane) => times.map((time) => valueAt(lane, time))));
}
