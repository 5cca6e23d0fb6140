/** Timelines of a stage: what drives the simulator and the picture depends on the step and on what people did only. */
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { ParameterError, SimulatorError } from '../../../src/base/errors.ts';
import type { AnyValues, Values } from '../../../src/parameters/parameter.ts';
import { readTimeline, valueAt } from '../../../src/parameters/timeline.ts';
import { defaults } from '../../../src/parameters/values.ts';
import { fetchTimelineText } from '../../../src/renderer/extraPasses.ts';
import { sceneNamed } from '../../../src/scenes/scenes.ts';
import { wisp } from '../../../src/scenes/wisp.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { StageValues } from '../../../src/stage/stageValues.ts';
import { readNote, takeOf } from '../../../src/stage/take.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';
import { TIMELINE_HASH, timelineHashes } from '../../support/sim/timelineHashes.ts';

const TIMELINE =
  '90*loop;emission.rate/0*20/30*200*e/70*40;forces.wind.x/10*0/40*3;emission.density/0*0:1,1:0/60*0:.2,1:0;' +
  'style.smokeColor/0*ffffff/60*000000;camera.azimuth/20*0/80*90;style.outlines/0*1/45*0;burst/15*0*20/50*0*7';
const VALUES: Values = { ...defaults(), scene: 'wisp', 'simulation.maxParticles': 500, timeline: TIMELINE };

let factory: SimulatorFactory;
beforeAll(async () => {
  factory = await loadVariant('core');
  await fetchTimelineText({ timeline: '60' });
});

/** A stage without a picture. */
class Bench {
  readonly simulation: Simulation;
  readonly values: StageValues;
  blend = 1;
  drawn: AnyValues;
  readonly eye = { held: {} as Values };
  readonly picture = { setValues: (values: Values) => void (this.drawn = values), eye: this.eye } as never;

  constructor(values: Values = VALUES, historyBytes = 1e7) {
    this.simulation = new Simulation(factory, wisp(), values, historyBytes);
    this.values = new StageValues(values, this);
    this.drawn = values;
  }

  get drawnTime(): number {
    return Math.max(0, this.simulation.simulator.steps - 1 + this.blend);
  }

  get hash(): string {
    return this.simulation.simulator.hash();
  }

  get rate(): number {
    return this.simulation.simulator.parameters().get('emission.rate')!;
  }

  show(change: () => void): void {
    change();
  }

  announce(): void {}

  /** Advances as playing does, and draws. */
  advance(steps: number): this {
    this.simulation.advance(steps);
    this.values.applyLog();
    return this.draw();
  }

  draw(): this {
    this.values.followTimeline();
    return this;
  }

  seek(step: number): this {
    this.simulation.approach(step);
    return this.advance(step - this.simulation.simulator.steps);
  }

  play(take: Uint8Array): this {
    this.values.adoptValues(this.simulation.playTake(take));
    return this.draw();
  }

  restore(state: Uint8Array): this {
    this.values.adoptValues(this.simulation.restore(state, this.values.all));
    return this.draw();
  }
}

const lane = (key: string) => readTimeline(TIMELINE).timeline.lanes.find((each) => each.key === key)!;
const at = (key: string, step: number) => valueAt(lane(key), step % 90);

describe('the simulator', () => {
  it('keeps what it has where a lane would give it a sixteenth look', () => {
    const looks = Array.from({ length: 14 }, (_, index) => ({ drag: 0.05 * index }));
    const timeline = '90;emitters.0.tint/0*0*h/30*2*h/60*0;emission.rate/0*20*h/50*70*h';
    const { simulation } = new Bench({ ...VALUES, 'emitters.0.look.drag': 5, timeline });
    const tintAfter = (steps: number) => {
      simulation.advance(steps);
      return simulation.simulator.parameters().get('emitters.0.tint');
    };
    expect(tintAfter(10)).toBe(0);
    for (const look of looks) simulation.emit({ position: { x: 0, y: 1, z: 0 }, rate: 1, look });
    expect(tintAfter(30)).toBe(0);
    expect(tintAfter(30)).toBe(0);
    expect(simulation.simulator.parameters().get('emission.rate')).toBe(70);
  });

  it('has the values of each step before it, and keeps those of people out of the values', () => {
    const bench = new Bench();
    for (let step = 0; step < 200; ++step) {
      bench.advance(1);
      expect(bench.rate, `step ${step}`).toBeCloseTo(at('emission.rate', step) as number, 10);
    }
    expect(bench.values.all).toEqual(VALUES);
  });

  it('gets constant values again after something else has set them', () => {
    const values: Values = { ...VALUES, timeline: '600;gravity.acceleration/0*3;emission.rate/0*50' };
    const gravityOf = (bench: Bench) => bench.simulation.simulator.parameters().get('gravity.acceleration');
    const bench = new Bench(values).advance(20);
    bench.values.unset(['gravity.acceleration']);
    expect(gravityOf(bench.advance(1))).toBe(3);
    const replay = new Bench(values).play(bench.simulation.take());
    expect(gravityOf(replay.advance(21))).toBe(3);
    const plain = new Bench({ ...VALUES, timeline: '' }).advance(21);
    const restored = new Bench(values).advance(21).restore(plain.simulation.save(plain.values.all));
    expect(restored.advance(1).rate, 'after a state of the same step').toBe(50);
    const sought = new Bench({ ...VALUES, timeline: '600;emission.rate/0*90*h/60*20' }).advance(100);
    sought.simulation.approach(70);
    expect(sought.simulation.simulator.steps).toBe(60);
    expect(sought.advance(1).rate, 'after a state before its keyframe').toBe(20);
    for (const each of [bench, replay, plain, restored, sought]) each.simulation.dispose();
  });

  it('gets the values of its lanes in place of those of a rule of the scene', async () => {
    const { hasRigids, load } = sceneNamed('dust');
    const scene = await load();
    const [key] = scene.rule!.keys.filter((each) => each.endsWith('.share'));
    const values: Values = { ...defaults(), scene: 'dust', timeline: `60;${key}/0*0.25` };
    const simulation = new Simulation(await loadVariant(hasRigids ? 'physics' : 'core'), scene, values, 0);
    simulation.advance(50);
    expect(simulation.simulator.parameters().get(key)).toBe(0.25);
    simulation.dispose();
  });

  it('emits bursts at their steps, again with each loop', () => {
    const bench = new Bench({
      ...VALUES,
      'emission.rate': 0,
      'emission.lifetime': 20,
      timeline: '90*loop;burst/15*0*20/50*0*7',
    });
    const births: [number, number][] = [];
    for (let step = 0; step < 180; ++step) {
      const before = bench.simulation.simulator.alive;
      bench.advance(1);
      const more = bench.simulation.simulator.alive - before;
      if (more > 0) births.push([step, more]);
    }
    expect(births).toEqual([
      [15, 20],
      [50, 7],
      [105, 20],
      [140, 7],
    ]);
  });

  it('emits nothing from an emitter that the scene lacks, and after the end', () => {
    const bench = new Bench({ ...VALUES, 'emission.rate': 0, timeline: '20;burst/5*7*20/20*0*3/30*0*3' });
    bench.advance(60);
    expect(bench.simulation.simulator.alive).toBe(0);
  });
});

const STRAIGHT = [30, 45, 60, 90, 100, 135, 180, 200];

/** Actions before steps: values held by people, in the middle of a lane and at a keyframe. */
function act(bench: Bench, step: number): void {
  if (step === 12) bench.values.set({ 'emission.rate': 400 });
  if (step === 40) bench.values.set({ 'forces.wind.x': -2, 'style.smokeColor': '#ff0000' });
  if (step === 70) bench.values.set({ 'emission.rate': 300 });
  if (step === 75) bench.values.set({ 'emission.lifetime': 1.5, 'style.inkColor': '#00ff00' });
  if (step === 110) bench.values.set({ 'style.outlines': 1, 'camera.azimuth': 5 });
  if (step === 150) bench.values.unset(['camera.azimuth']);
}

/** What a state and a picture are at each step. */
function stateOf({ hash, drawn }: Bench): [hash: string, look: AnyValues] {
  const look = Object.entries(drawn).filter(([key]) => /^(style|light|camera)\./.test(key));
  return [hash, Object.fromEntries(look)];
}

function live(bench: Bench, until = 200): Map<number, unknown> {
  const states = new Map<number, unknown>();
  for (let step = 0; step < until; ++step) {
    act(bench, step);
    bench.advance(1);
    if (STRAIGHT.includes(step + 1)) states.set(step + 1, stateOf(bench));
  }
  return states;
}

describe('the same state and picture at a step', () => {
  let states: Map<number, unknown>;
  let take: Uint8Array;
  beforeEach(() => {
    const bench = new Bench();
    states = live(bench);
    take = bench.simulation.take();
    bench.simulation.dispose();
  });

  it.each([1e7, 0])('come from a replay and its seeks, with %d bytes of history', (historyBytes) => {
    const bench = new Bench({ ...VALUES, timeline: '' }, historyBytes).play(take);
    for (const step of [200, 30, 180, 60, 45, 135, 90, 100])
      expect(stateOf(bench.seek(step))).toEqual(states.get(step));
    expect(bench.simulation.take()).toEqual(take);
    bench.simulation.dispose();
  });

  it('come from steps in batches', () => {
    const bench = new Bench().play(take);
    for (const step of STRAIGHT) expect(stateOf(bench.seek(step))).toEqual(states.get(step));
    bench.simulation.dispose();
  });

  it.each([13, 40, 70, 71, 88, 111])(
    'come from a state that was saved after %d steps and what was done there',
    (step) => {
      const first = new Bench();
      live(first, step);
      act(first, step);
      const second = new Bench({ ...first.values.all }).restore(first.simulation.save(first.values.all));
      expect(second.hash).toBe(first.hash);
      for (const bench of [first, second]) bench.advance(30);
      expect(second.hash).toBe(first.hash);
      expect(second.drawn).toEqual(first.drawn);
      for (const bench of [first, second]) bench.simulation.dispose();
    },
  );

  it('comes from seeks in the session itself, as far as the timeline animates it', () => {
    const bench = new Bench();
    live(bench);
    for (const step of [180, 60, 200]) {
      bench.seek(step);
      const [hash, look] = states.get(step) as [string, AnyValues];
      // The look that people chose stays after a seek back.
      expect(stateOf(bench)).toEqual([hash, { ...look, 'style.inkColor': '#00ff00' }]);
    }
    bench.simulation.dispose();
  });
});

it('a timeline with each kind of parameter ends in the recorded state, played, sought and replayed', async () => {
  const hashes = await timelineHashes(factory);
  expect(new Set(Object.values(hashes))).toEqual(new Set([TIMELINE_HASH]));
});

describe('a change by a person', () => {
  it('holds until the next keyframe of its lane', () => {
    const bench = new Bench().advance(12);
    bench.values.set({ 'emission.rate': 400, 'style.smokeColor': '#ff0000' });
    expect(bench.draw().drawn['style.smokeColor']).toBe('#ff0000');
    for (let step = 12; step < 30; ++step) expect(bench.advance(1).rate, `step ${step}`).toBe(400);
    expect(bench.advance(1).rate).toBe(200);
    expect(bench.values.all['emission.rate']).toBe(400);
    bench.advance(28);
    expect(bench.drawn['style.smokeColor']).toBe('#ff0000');
    expect(bench.advance(1).drawn['style.smokeColor'], 'the keyframe at 60').toBe('#000000');
    bench.simulation.dispose();
  });

  it('at a keyframe holds until the one after it, and in a loop into the next turn', () => {
    const bench = new Bench().advance(70);
    bench.values.set({ 'emission.rate': 300 });
    for (let step = 70; step < 90; ++step) expect(bench.advance(1).rate).toBe(300);
    expect(bench.advance(1).rate).toBe(20);
    bench.simulation.dispose();
  });

  it('to the value that was set before holds as well', () => {
    const bench = new Bench({ ...VALUES, 'emission.rate': 60 }).advance(20);
    bench.values.set({ 'emission.rate': 60 });
    expect(bench.advance(1).rate).toBe(60);
    bench.simulation.dispose();
  });

  it('ends when its lane is edited, and not when another one is', () => {
    const bench = new Bench({ ...VALUES, timeline: '120;emission.rate/0*20' }).advance(40);
    const rateAt = (step: number) => bench.seek(step).advance(1).rate;
    bench.values.set({ 'emission.rate': 100 });
    bench.values.set({ timeline: '120;emission.rate/0*20;style.smokeColor/0*ffffff/60*000000' });
    expect([rateAt(30), rateAt(60)]).toEqual([20, 100]);
    bench.values.set({ timeline: '120;emission.rate/0*20/40*100/80*20' });
    expect([rateAt(20), rateAt(40), rateAt(60), rateAt(90)]).toEqual([60, 100, 60, 20]);
    bench.simulation.dispose();
  });

  it('before the parameter has a lane does not hold', () => {
    const bench = new Bench({ ...VALUES, timeline: '' }).advance(30);
    bench.values.set({ 'style.smokeColor': '#00ff00', 'style.inkColor': '#0000ff' });
    bench.values.set({ timeline: '120;style.smokeColor/0*ffffff/60*000000' });
    expect(bench.seek(45).drawn).toMatchObject({ 'style.smokeColor': '#404040', 'style.inkColor': '#0000ff' });
    // Takes agree.
    const take = bench.simulation.take();
    expect(bench.play(take).advance(45).drawn['style.smokeColor']).toBe('#404040');
    bench.simulation.dispose();
  });

  it('of all values to what they are changes nothing', () => {
    const bench = new Bench({ ...VALUES, 'emission.rate': 60 }).advance(20);
    bench.values.set(bench.values.all);
    expect(bench.simulation.simulator.inputCount).toBe(0);
    expect(bench.advance(1).rate).toBeCloseTo(at('emission.rate', 20) as number, 10);
    bench.simulation.dispose();
  });

  it('ends when it is unset', () => {
    const bench = new Bench().advance(50);
    bench.values.set({ 'camera.azimuth': -10 });
    expect(bench.advance(1).drawn['camera.azimuth']).toBe(-10);
    bench.values.unset(['camera.azimuth']);
    expect(bench.draw().drawn['camera.azimuth']).toBeCloseTo(at('camera.azimuth', 51) as number, 10);
    expect(bench.values.all).not.toHaveProperty('camera.azimuth');
    bench.simulation.dispose();
  });

  it('by the camera holds for what it moved', () => {
    const bench = new Bench().advance(50);
    const before = { 'camera.azimuth': 40, 'camera.distance': 3 };
    bench.eye.held = { ...before, 'camera.distance': 5 };
    bench.values.adoptCamera(before);
    expect(bench.values.all).toMatchObject({ 'camera.distance': 5 });
    expect(bench.values.all).not.toHaveProperty('camera.azimuth');
    bench.simulation.dispose();
  });
});

describe('in record mode, a change', () => {
  it('makes keyframes of animated parameters, and leaves the values', () => {
    const bench = new Bench().advance(50);
    bench.values.recordsKeyframes = true;
    bench.values.set({ 'emission.rate': 111, 'style.smokeColor': '#00ff00', 'style.inkColor': '#0000ff' });
    const { lanes } = readTimeline(bench.values.all.timeline!).timeline;
    expect(lanes[0].keyframes.find(({ step }) => step === 50)).toEqual({ step: 50, value: 111, easing: 'ease' });
    expect(lanes.find(({ key }) => key === 'style.smokeColor')!.keyframes[1]).toEqual({
      step: 50,
      value: '#00ff00',
      easing: 'linear',
    });
    expect(bench.values.all).toMatchObject({ 'emission.rate': VALUES['emission.rate'], 'style.inkColor': '#0000ff' });
    expect(bench.draw().drawn).toMatchObject({ 'style.smokeColor': '#00ff00', 'style.inkColor': '#0000ff' });
    expect(bench.advance(1).rate).toBe(111);
    expect(bench.simulation.simulator.inputCount).toBe(0);
    bench.simulation.dispose();
  });

  it('that contains a timeline makes none', () => {
    const bench = new Bench().advance(50);
    bench.values.recordsKeyframes = true;
    const timeline = '60;emission.rate/0*5';
    bench.values.set({ 'emission.rate': 111, timeline });
    expect(bench.values.all).toMatchObject({ 'emission.rate': 111, timeline });
    bench.simulation.dispose();
  });

  it('holds when the timeline is full', () => {
    const full = `600;emission.rate/${Array.from({ length: 512 }, (_, step) => `${step}*1`).join('/')}`;
    const bench = new Bench({ ...VALUES, timeline: full }).advance(550);
    bench.values.recordsKeyframes = true;
    bench.values.set({ 'emission.rate': 111 });
    expect(bench.values.all).toMatchObject({ timeline: full, 'emission.rate': 111 });
    expect(bench.advance(1).rate).toBe(111);
    bench.simulation.dispose();
  });

  it('of the camera makes keyframes', () => {
    const bench = new Bench().advance(50);
    bench.values.recordsKeyframes = true;
    bench.eye.held = { 'camera.azimuth': 33 };
    bench.values.adoptCamera({ 'camera.azimuth': 45 });
    expect(bench.draw().drawn['camera.azimuth']).toBe(33);
    expect(bench.values.all).not.toHaveProperty('camera.azimuth');
    bench.simulation.dispose();
  });
});

it('needs no more memory with time', () => {
  const bench = new Bench().advance(200);
  const { memory } = factory.module;
  const before = memory.buffer.byteLength;
  for (let turn = 0; turn < 20; ++turn) {
    bench.advance(90);
    bench.values.set({ 'emission.rate': 100 + turn });
  }
  expect(memory.buffer.byteLength).toBe(before);
  bench.simulation.dispose();
});

describe('another timeline', () => {
  it('applies to all time with the next seek, from the saved state before the difference', () => {
    const straight = new Bench({ ...VALUES, timeline: TIMELINE.replace('70*40', '70*90') }).advance(130);
    const bench = new Bench().advance(130);
    bench.values.set({ timeline: TIMELINE.replace('70*40', '70*90') });
    expect(bench.seek(130).hash).toBe(straight.hash);
    const counted = new Bench().advance(130);
    counted.values.set({ timeline: TIMELINE.replace('70*40', '70*90') });
    counted.simulation.approach(130);
    // The segment before the keyframe at 70 begins at 30.
    expect(counted.simulation.simulator.steps).toBe(0);
    for (const each of [straight, bench, counted]) each.simulation.dispose();
  });

  it('keeps the states if only the future or the picture differs', () => {
    const bench = new Bench({ ...VALUES, timeline: '900;emission.rate/0*20/60*50/200*90' }).advance(100);
    bench.values.set({ timeline: '900;emission.rate/0*20/60*50*h/200*90;style.smokeColor/0*ffffff' });
    bench.simulation.approach(100);
    expect(bench.simulation.simulator.steps, 'from 60 on it differs').toBe(60);
    bench.advance(40);
    bench.values.set({ timeline: '900;emission.rate/0*20/60*50*h/200*10;style.smokeColor/0*000000' });
    bench.simulation.approach(100);
    expect(bench.simulation.simulator.steps).toBe(60);
    bench.advance(40);
    bench.values.set({ timeline: '900;emission.rate/0*20/60*50*h/200*10;style.smokeColor/0*ff0000' });
    bench.simulation.approach(100);
    expect(bench.simulation.simulator.steps).toBe(100);
    expect(bench.draw().drawn['style.smokeColor']).toBe('#ff0000');
    bench.simulation.dispose();
  });

  it('is an error of a caller if a part is invalid, and changes nothing', () => {
    const bench = new Bench();
    const before = bench.values.all;
    for (const timeline of ['60;no.such/0*1', '60;seed/0*1', '60;emission.rate/0*-1', 'what', '60;emission.rate'])
      expect(() => bench.values.set({ timeline, 'emission.rate': 9 })).toThrow(ParameterError);
    expect(bench.values.all).toBe(before);
    bench.simulation.dispose();
  });
});

describe('the drawn time', () => {
  it('lies between steps for style, light and camera', () => {
    const bench = new Bench().advance(30);
    const colors = [0, 0.25, 0.5, 1].map((blend) => {
      bench.blend = blend;
      return bench.draw().drawn['style.smokeColor'];
    });
    const wanted = [29, 29.25, 29.5, 30].map((time) => valueAt(lane('style.smokeColor'), time));
    expect(colors).toEqual(wanted);
    bench.simulation.dispose();
  });

  it('gives values to read-outs, those of the simulator too', () => {
    const bench = new Bench().advance(30);
    expect(bench.values.shown).toMatchObject({ 'emission.rate': 200, 'style.smokeColor': '#808080' });
    expect(bench.values.all['emission.rate']).toBe(VALUES['emission.rate']);
    bench.simulation.dispose();
  });

  it('is that of other values for a picture, without a change', () => {
    const bench = new Bench().advance(30);
    bench.values.showWith({ 'style.smokeColor': '#123456' });
    expect(bench.draw().drawn['style.smokeColor']).toBe('#123456');
    bench.values.showWith({});
    expect(bench.draw().drawn['style.smokeColor']).toBe('#808080');
    expect(bench.advance(35).drawn['style.smokeColor']).toBe('#000000');
    bench.simulation.dispose();
  });
});

describe('a take', () => {
  const PLAIN: Values = { ...VALUES, timeline: '' };

  it('repeats changes of style, light and camera at their steps', () => {
    const bench = new Bench(PLAIN);
    const drawn: AnyValues[] = [];
    for (let step = 0; step < 60; ++step) {
      if (step % 7 === 3)
        bench.values.set({ 'style.rim': step / 100, 'light.azimuth': step, 'camera.distance': 2 + step / 4 });
      if (step % 20 === 19) bench.values.unset(['camera.distance']);
      drawn.push(bench.draw().drawn);
      bench.advance(1);
    }
    const take = bench.simulation.take();
    expect(takeOf(take, factory.readTake(take))).toMatchObject({
      inputs: 0,
      isTruncated: false,
      changed: ['style.rim', 'light.azimuth', 'camera.distance'],
    });
    const other = new Bench(PLAIN).play(take);
    for (const values of drawn) {
      expect(other.drawn).toEqual(values);
      other.advance(1);
    }
    expect(other.simulation.take()).toEqual(take);
    for (const step of [40, 7, 59, 19]) expect(other.seek(step).drawn).toEqual(drawn[step]);
    for (const each of [bench, other]) each.simulation.dispose();
  });

  it('has the bytes of before without such changes', () => {
    const bench = new Bench(PLAIN).advance(5);
    expect(factory.readTake(bench.simulation.take()).note).toBe(
      JSON.stringify({ values: { scene: 'wisp', 'simulation.maxParticles': 500 } }),
    );
    bench.simulation.dispose();
  });

  it('lets a person take over: later changes of the same parameter do not come', () => {
    const bench = new Bench(PLAIN);
    for (const color of ['#110000', '#220000', '#330000']) {
      bench.values.set({ 'style.smokeColor': color, 'style.inkColor': color });
      bench.advance(10);
    }
    const other = new Bench(PLAIN).play(bench.simulation.take()).advance(15);
    other.values.set({ 'style.smokeColor': '#ffffff' });
    other.advance(15);
    expect(other.drawn).toMatchObject({ 'style.smokeColor': '#ffffff', 'style.inkColor': '#330000' });
    other.seek(5);
    expect(other.drawn, 'the look of a person stays').toMatchObject({
      'style.smokeColor': '#ffffff',
      'style.inkColor': '#110000',
    });
    for (const each of [bench, other]) each.simulation.dispose();
  });

  it('can leave out the look, but not what a person holds of the timeline', () => {
    const bench = new Bench().advance(12);
    bench.values.set({ 'emission.rate': 400, 'style.inkColor': '#00ff00' });
    bench.advance(20);
    const take = bench.simulation.take(false);
    expect(takeOf(take, factory.readTake(take)).changed).toEqual([]);
    const other = new Bench(PLAIN).play(take).advance(32);
    expect(other.hash).toBe(bench.hash);
    expect(other.drawn['style.inkColor']).toBe(VALUES['style.inkColor']);
    for (const each of [bench, other]) each.simulation.dispose();
  });

  it('stops to record changes at 40,000 characters, and says so', () => {
    const bench = new Bench(PLAIN);
    let color = 0;
    const drag = (steps: number) => {
      for (let step = 0; step < steps; ++step) {
        bench.values.set({ 'style.smokeColor': `#${(++color).toString(16).padStart(6, '0')}` });
        bench.simulation.advance(1);
      }
    };
    drag(3000);
    const { note } = factory.readTake(bench.simulation.take());
    expect(readNote(note).isTruncated).toBe(true);
    expect(note.length).toBeLessThan(41_000);
    expect(bench.values.all['style.smokeColor']).toBe('#000bb8');
    bench.values.applyLog();
    expect(bench.values.all['style.smokeColor'], 'the last change stays').toBe('#000bb8');
    const take = takeOf(bench.simulation.take(), factory.readTake(bench.simulation.take()));
    expect(take.isTruncated).toBe(true);
    bench.simulation.dispose();
  });

  it('ignores changes that no stage has recorded', () => {
    const values = { scene: 'wisp', 'simulation.maxParticles': 500 };
    const keys = ['style.rim', 'seed', 'no.such', '__proto__', 'camera.distance', 7, {}];
    const changes = [
      0,
      0,
      7,
      -3,
      0,
      0.5,
      1.5,
      0,
      0.5,
      '1',
      0,
      0.5,
      3,
      0,
      null,
      4,
      0,
      {},
      5,
      0,
      'x',
      1,
      1,
      7,
      1,
      2,
      3,
      1,
      3,
      1,
    ];
    const hostile = [...changes, 6, 4, null, 1, 5, 1, 1, 6, 1, 1, 99, 1, 8, 0, 0.25, 9, 0];
    const bench = new Bench(PLAIN);
    bench.play(bench.simulation.simulator.take(JSON.stringify({ values, changes: [keys, hostile] })));
    bench.advance(20);
    expect(bench.drawn).toEqual({ ...PLAIN, 'style.rim': 0.25 });
    for (const strange of [7, [], [[]], [7, 8], [{}, {}], null, 'text', [null, null]]) {
      const take = bench.simulation.simulator.take(JSON.stringify({ values, changes: strange }));
      try {
        bench.play(take).advance(2);
      } catch (error) {
        expect(error).toBeInstanceOf(SimulatorError);
      }
    }
    bench.simulation.dispose();
  });
});
