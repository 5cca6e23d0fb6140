/** Timelines on stages: before their code is loaded, at times between steps, in workers. */
import { ParameterError } from '../../../src/base/errors.ts';
import type { AnyValues } from '../../../src/parameters/parameter.ts';
import { readTimeline } from '../../../src/parameters/timeline.ts';
import { openStage } from '../../../src/stage/remote/openStage.ts';
import { createStage, type Stage } from '../../../src/stage/stage.ts';
import { PLAIN_LOOK } from '../../support/plainLook.ts';

const TEXT =
  '90*loop;emission.rate/0*20/30*120*e/70*40;style.smokeColor/0*ffffff/60*000000;camera.azimuth/20*0/80*90;' +
  'style.strokes/0*0/60*0*h/61*1;burst/15*0*20';
const SIZE = { width: 80, height: 60 };
const VALUES = { ...PLAIN_LOOK, scene: 'wisp', 'simulation.maxParticles': 300, 'puff.variations': 1 } as const;

function open(timeline?: string): Promise<Stage> {
  const values = timeline === undefined ? VALUES : { ...VALUES, timeline };
  return createStage(document.createElement('canvas'), { values, ...SIZE });
}

/** The hash after 100 steps of stages that get the timeline in each way, the first of them before its code is loaded. */
export async function hashes(): Promise<{ first: string[]; hashes: Record<string, string> }> {
  const late = await open();
  late.set({ timeline: readTimeline(TEXT).timeline });
  const first = [String(late.get().timeline)];
  late.step(40);
  late.advance(1);
  first.push(String(late.stats.steps));
  await late.complete();
  first.push(String(late.stats.steps), String(late.get().timeline === TEXT));
  const created = await open(TEXT);
  created.step(100);
  const sought = await open();
  sought.set({ timeline: TEXT });
  await sought.seek(100 / 60);
  const entered = await open();
  await entered.enter({ ...VALUES, timeline: readTimeline(TEXT).timeline });
  entered.step(100);
  const replayed = await open();
  replayed.playTake(created.take());
  replayed.step(100);
  const half = await open(TEXT);
  half.step(50);
  half.set({ 'emission.rate': 3 });
  const copy = await half.copy(document.createElement('canvas'), SIZE);
  half.step(10);
  copy.step(10);
  const stages = { late, created, sought, entered, replayed };
  const found = Object.entries(stages).map(([name, stage]) => [name, stage.hash()]);
  const held = [half.hash(), copy.hash()];
  for (const stage of [...Object.values(stages), half, copy]) stage.dispose();
  return {
    first: [...first, String(held[0] === held[1])],
    hashes: Object.fromEntries(found) as Record<string, string>,
  };
}

/** What the picture has at times between steps, shown as a film does. */
export async function betweenSteps(): Promise<{ colors: unknown[]; azimuths: number[]; base: unknown[] }> {
  const stage = await open(TEXT);
  await stage.complete();
  const report: { colors: unknown[]; azimuths: number[] } = { colors: [], azimuths: [] };
  for (const frame of [0, 6, 12, 13, 14, 30]) {
    stage.running.showAt(frame / 24);
    const values: AnyValues = stage.running.picture.smoke.values;
    report.colors.push(values['style.smokeColor']);
    report.azimuths.push(Number(values['camera.azimuth']));
  }
  const { ['style.smokeColor']: color, ...rest } = stage.get();
  stage.dispose();
  return { ...report, base: [color, 'camera.azimuth' in rest] };
}

/** Whether drawn smoke has the colours of its emitter's look while the timeline changes the colour of the smoke. */
export async function looksWhileAnimated(): Promise<boolean[]> {
  const values = { ...VALUES, timeline: TEXT, 'emitters.0.look.colors': '0:ff0000,1:00ff00' };
  const stage = await createStage(document.createElement('canvas'), { values, ...SIZE });
  await stage.seek(1);
  await stage.complete();
  const found: boolean[] = [];
  stage.on('frame', () => found.push(stage.running.picture.smoke.style.looks !== undefined));
  for (let frame = 0; frame < 3; ++frame) stage.step(1);
  stage.dispose();
  return found;
}

/** The code that pictures need later is loaded before, so that no picture lacks it. */
export async function strokesLater(): Promise<boolean[]> {
  const stage = await open(TEXT);
  stage.step(70);
  const { loaded } = await import('../../../src/renderer/extraPasses.ts');
  const found = [loaded.strokes !== undefined, stage.running.picture.smoke.style.strokes === 1];
  stage.dispose();
  return found;
}

/** Errors of invalid timelines, by the call, and the timeline that stays. */
export async function invalid(): Promise<Record<string, string>> {
  const stage = await open('60;emission.rate/0*5');
  const report: Record<string, string> = {};
  const events: Error[] = [];
  stage.on('error', (error) => events.push(error));
  const attempt = async (name: string, act: () => unknown) => {
    try {
      await act();
    } catch (error) {
      report[name] = error instanceof ParameterError ? error.key : String(error);
    }
  };
  const bad = '60;emission.rate/0*-5';
  await attempt('create', () => open(bad));
  await attempt('set', () => stage.set({ timeline: bad }));
  await attempt('object', () => stage.set({ timeline: { length: 0 } as never }));
  await attempt('enter', () => stage.enter({ ...VALUES, timeline: bad }));
  report.left = String(stage.get().timeline);
  report.events = String(events.length);
  stage.dispose();
  return report;
}

/** A stage whose timeline is invalid, before the code is loaded: a fresh page calls it. */
export async function invalidBefore(): Promise<string[]> {
  const stage = await open();
  const errors: string[] = [];
  stage.on('error', (error) => errors.push((error as ParameterError).key));
  stage.set({ timeline: { length: 60, loops: false, lanes: [{ key: 'seed', keyframes: [] }], bursts: [] } });
  stage.step(3);
  await stage.complete();
  errors.push(String(stage.get().timeline), String(stage.stats.steps));
  stage.dispose();
  return errors;
}

/** Hashes of a remote stage after the timeline comes as an object, and the error of an invalid one. */
export async function remote(thread: 'main' | 'worker'): Promise<string[]> {
  const canvas = document.createElement('canvas');
  document.body.append(canvas);
  const stage = await openStage(() => canvas, { values: VALUES, ...SIZE, thread });
  const set = stage.set({ timeline: readTimeline(TEXT).timeline });
  const stepped = stage.step(100);
  await Promise.all([set, stepped]);
  const report = [await stage.hash(), String((await stage.get()).timeline === TEXT)];
  await stage.set({ timeline: '60;seed/0*5' }).catch((error: ParameterError) => report.push(error.key));
  await stage.dispose();
  canvas.remove();
  return report;
}
