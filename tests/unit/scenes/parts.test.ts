/** Items attached to moving parts of a scene follow them, and every way of running it gives the same hashes. */
import { describe, expect, it, vi } from 'vitest';
import { decode, encode, type State } from '../../../src/parameters/codec.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { findParameter } from '../../../src/parameters/table.ts';
import { AIRSPEED, airplane } from '../../../src/scenes/airplane.ts';
import { cloudscape, WIND } from '../../../src/scenes/cloudscape.ts';
import { HUB, PROPELLER } from '../../../src/scenes/models/airplane.ts';
import { AXLE } from '../../../src/scenes/models/meadow.ts';
import type { Scene, Vector } from '../../../src/scenes/scene.ts';
import { STEP_SECONDS } from '../../../src/simulator/clock.ts';
import { FIRST_PART } from '../../../src/simulator/layout.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { noteOf } from '../../../src/stage/take.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const RATE = 600;
const TIP = 0.7;
const STILL: Values = { 'emission.rate': RATE, 'emission.lifetime': 60, 'forces.turbulence': 0 };

/** Puffs that stay at their spawn position, on the y axis of the first part. */
const NOZZLE = {
  'emitters.0.rigid': FIRST_PART,
  'emitters.0.position.y': TIP,
  'emitters.0.speed': 0,
  'emitters.0.size': 0.02,
  'buoyancy.acceleration': 0,
  'gravity.acceleration': 0,
};

interface Wheel {
  variant: 'core' | 'physics';
  scene: Scene;
  hub: Vector;
  /** The rotation axis. */
  axis: 0 | 2;
  /** rad/s. */
  rate: number;
}

const plane = airplane();
const [planeRigid] = plane.rigids;
const WHEELS: readonly Wheel[] = [
  {
    variant: 'physics',
    // Small enough to collide with nothing, and flying in place.
    scene: { ...plane, rigids: [{ ...planeRigid, shape: { type: 'ball', radius: 0.001 } }], guide: undefined },
    hub: HUB.map((at, axis) => at + plane.handle!.start[axis]) as unknown as Vector,
    axis: 0,
    rate: 2 * Math.PI * 3.2,
  },
  { variant: 'core', scene: cloudscape(), hub: AXLE, axis: 2, rate: 0.9 * WIND },
];

describe('an emitter at the tip of', () => {
  it.each(WHEELS)('a wheel leaves an even circle, in $scene.name', async ({ variant, scene, hub, axis, rate }) => {
    const values = { ...presetValues(findPreset(scene.name)!), ...STILL };
    const simulation = new Simulation(await loadVariant(variant), { ...scene, rig: NOZZLE }, values, 0);
    simulation.advance(60);
    const { x, y, z } = readParticles(simulation.simulator);
    expect(x).toHaveLength(RATE);
    const [across, up] = [(axis + 1) % 3, (axis + 2) % 3];
    // On its own y axis at the start.
    const start = Math.atan2(...([axis === 0 ? 0 : 1, axis === 0 ? 1 : 0] as const));
    x.forEach((_, birth) => {
      const place = [x[birth], y[birth], z[birth]].map((at, along) => at - hub[along]);
      expect(place[axis]).toBeCloseTo(0, 5);
      expect(Math.hypot(place[across], place[up])).toBeCloseTo(TIP, 2);
      const angle = (rate * (birth + 1)) / RATE;
      const off = Math.atan2(place[up], place[across]) - (start + angle);
      expect(Math.abs(Math.sin(off / 2)), `birth ${birth}`).toBeLessThan(1e-3);
    });
    simulation.dispose();
  });
});

it('passes the exact numbers of the scene to the simulator, at the start and at the end of the step', async () => {
  const values = presetValues(findPreset('airplane')!);
  const simulation = new Simulation(await loadVariant('physics'), plane, values, 0);
  simulation.advance(7);
  const placeParts = vi.spyOn(simulation.simulator, 'placeParts');
  simulation.advance(1);
  const expected = [7, 8].flatMap((step) =>
    plane.parts!.flatMap(({ rigid, pose }) => {
      const { position, rotation } = pose(step * STEP_SECONDS);
      return [rigid, ...position, ...rotation];
    }),
  );
  expect(placeParts.mock.calls).toEqual([[expected]]);
  simulation.dispose();
});

describe('a vortex, an emitter and a shedder on the propeller', () => {
  const VALUES: Values = { ...presetValues(findPreset('airplane')!), 'emission.rate': 120 };
  const ON_PROPELLER = FIRST_PART + PROPELLER;
  const RIDERS: Values = {
    'vortices.0.circulation': 3,
    'vortices.0.position.y': TIP,
    'vortices.0.axis.x': 1,
    'vortices.0.rigid': ON_PROPELLER,
    'emitters.4.position.y': TIP,
    'emitters.4.inherit': 0.5,
    'emitters.4.rigid': ON_PROPELLER,
    'shedders.2.rate': 20,
    'shedders.2.extent.y': TIP,
    'shedders.2.rigid': ON_PROPELLER,
  };
  const STEPS = 130;

  /** Steers the flight, with the smoke of the scene. */
  function fly(simulation: Simulation): string {
    while (simulation.simulator.steps < STEPS) {
      const { steps } = simulation.simulator;
      if (steps === 50) simulation.input((simulator) => simulator.inputSteer(1, 0.8));
      if (steps === 70) simulation.set({ 'simulation.integrator': 'paper' });
      simulation.advance(1);
    }
    return simulation.simulator.hash();
  }

  it('reach the same hash by seeking, with and without saved states, and by their take', async () => {
    const factory = await loadVariant('physics');
    const begin = (riders: Values, historyBytes: number) =>
      new Simulation(factory, airplane(), { ...VALUES, ...riders }, historyBytes);
    const bare = begin({}, 0);
    const hashes = new Set<string>();
    for (const historyBytes of [0, 1e8]) {
      const simulation = begin(RIDERS, historyBytes);
      hashes.add(fly(simulation));
      for (const back of [100, 61, 3]) {
        simulation.approach(back);
        expect(simulation.simulator.steps).toBeLessThanOrEqual(back);
        simulation.advance(STEPS - simulation.simulator.steps);
        hashes.add(simulation.simulator.hash());
      }
      const saved = simulation.simulator.save();
      simulation.advance(20);
      const later = simulation.simulator.hash();

      const replayed = begin({}, historyBytes);
      replayed.advance(33);
      replayed.replay(simulation.simulator.take(noteOf({ values: simulation.startValues })), simulation.startValues);
      replayed.advance(STEPS);
      hashes.add(replayed.simulator.hash());
      replayed.restore(saved, VALUES);
      replayed.advance(20);
      expect(replayed.simulator.hash()).toBe(later);
      simulation.dispose();
      replayed.dispose();
    }
    expect([...hashes]).toHaveLength(1);
    expect(hashes).not.toContain(fly(bare));
    bare.dispose();
  });

  it('leave a helix that drifts with the wind', async () => {
    const rig = { ...NOZZLE, 'winds.0.velocity.x': -AIRSPEED };
    const scene = { ...WHEELS[0].scene, rig };
    const simulation = new Simulation(await loadVariant('physics'), scene, { ...VALUES, ...STILL }, 0);
    simulation.advance(60);
    const { x, y, z } = readParticles(simulation.simulator);
    const { hub, rate } = WHEELS[0];
    x.forEach((at, birth) => {
      const since = 1 - (birth + 1) / RATE;
      expect(at - hub[0]).toBeCloseTo(-AIRSPEED * since, 2);
      const off = Math.atan2(z[birth] - hub[2], y[birth] - hub[1]) - rate * (1 - since);
      expect(Math.abs(Math.sin(off / 2)), `birth ${birth}`).toBeLessThan(2e-3);
    });
    simulation.dispose();
  });

  it('are stored in a link, and numbers beyond the last part are not', async () => {
    const state: State = { preset: 'airplane', values: { ...presetValues(findPreset('airplane')!), ...RIDERS } };
    const link = await encode(state);
    expect(link).toContain('vortices.0.rigid=4096');
    expect(await decode(link)).toEqual({ state, notices: [] });
    const beyond = await decode('#v=1&preset=airplane&vortices.0.rigid=4352');
    expect(beyond.state.values['vortices.0.rigid']).toBe(4351);
    expect(beyond.notices.map(({ code }) => code)).toEqual(['outOfRange']);
    expect(findParameter('vortices.0.rigid')).toMatchObject({ max: FIRST_PART + 255 });
  });
});
