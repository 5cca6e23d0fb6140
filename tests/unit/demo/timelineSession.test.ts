/** Actions on the timeline of the page, with the editor of the page and a stage that plays no smoke. */
import { describe, expect, it } from 'vitest';
import type { Stage } from '../../../src/index.ts';
import { Editor } from '../../../src/demo/editor/editor.ts';
import type { Scrubber } from '../../../src/demo/playback/scrubber.ts';
import { markOf } from '../../../src/demo/timeline/model.ts';
import { Session } from '../../../src/demo/timeline/session.ts';
import { defaultState } from '../../../src/parameters/codec.ts';
import type { AnyValues, Values } from '../../../src/parameters/parameter.ts';
import { readTimeline, timeIn, valueAt } from '../../../src/parameters/timeline.ts';

const RATE = 'emission.rate';

class FakeStage {
  values: Values = { ...defaultState().values, [RATE]: 40 };
  readonly rig: AnyValues = { 'camera.azimuth': 10 };
  readonly held: AnyValues[] = [];
  stats = { time: 0 };
  playing = false;
  private readonly listeners: { event: string; listener: () => void }[] = [];

  get = () => this.values;

  on = (event: string, listener: unknown) => {
    this.listeners.push({ event, listener: listener as () => void });
    return () => {};
  };

  get shown(): AnyValues {
    const { lanes, ...rest } = readTimeline(this.values.timeline ?? '').timeline;
    const at = timeIn(rest, 60 * this.stats.time);
    return { ...(this.values as AnyValues), ...Object.fromEntries(lanes.map((lane) => [lane.key, valueAt(lane, at)])) };
  }

  set(values: AnyValues): void {
    this.held.push(values);
  }

  replace(values: Values): void {
    this.values = values;
    this.tell('statechange');
  }

  /** A gesture on the stage. */
  turn(azimuth: number): void {
    this.replace({ ...this.values, 'camera.azimuth': azimuth });
  }

  /** Plays to a step. */
  play(step: number): void {
    this.playing = true;
    for (let at = Math.round(60 * this.stats.time) + 1; at <= step; at++) this.go(at);
    this.playing = false;
  }

  go(step: number): void {
    this.stats = { time: step / 60 };
    this.tell('frame');
  }

  private tell(event: string): void {
    for (const each of this.listeners) if (each.event === event) each.listener();
  }
}

function editing(timeline = '') {
  const stage = new FakeStage();
  if (timeline) stage.values = { ...stage.values, timeline };
  const said: string[] = [];
  const seeks: number[] = [];
  const scrubber = { wanted: undefined, go: async (seconds: number) => void seeks.push(Math.round(60 * seconds)) };
  const editor = new Editor(stage as never, defaultState().preset, {
    nextFrame: () => Promise.resolve(),
    enter: () => Promise.resolve(),
    setModel: () => Promise.resolve(),
    notify: (message) => said.push(message),
  });
  const session = new Session({
    editor,
    stage: stage as unknown as Stage,
    scrubber: scrubber as unknown as Scrubber,
  });
  session.say = (sentence) => said.push(sentence);
  return { stage, editor, session, said, seeks, text: () => editor.state.values.timeline ?? '' };
}

describe('keyframes', () => {
  it('get the value in effect, and are removed again', async () => {
    const { stage, editor, session, text, said } = editing();
    session.toggleKeyframe(RATE);
    await editor.delivered();
    stage.go(60);
    editor.change(RATE, 100);
    await editor.delivered();
    session.toggleKeyframe('camera.azimuth');
    expect(text()).toBe(`600;${RATE}/0*40*e;camera.azimuth/60*10*e`);
    session.toggleKeyframe('camera.azimuth');
    expect(text()).toBe(`600;${RATE}/0*40*e`);
    session.toggleKeyframe('seed');
    expect(said.at(-1)).toMatch(/^Seed cannot be animated\. /);
    editor.undo();
    expect(text()).toContain('camera.azimuth');
  });

  it('are dragged as one undo step, and stay when the drag is cancelled', () => {
    const { editor, session, text } = editing(`600;${RATE}/0*1/60*2`);
    session.select(new Set([markOf(RATE, 60)]));
    session.beginDrag(false);
    for (const steps of [10, -60, 30]) session.drag(steps);
    expect(text()).toBe(`600;${RATE}/0*1/90*2`);
    session.endDrag(true);
    expect([...session.marks]).toEqual([markOf(RATE, 90)]);
    editor.undo();
    expect(text()).toBe(`600;${RATE}/0*1/60*2`);
    session.select(new Set([markOf(RATE, 60)]));
    session.beginDrag(true);
    session.drag(30);
    expect(text()).toBe(`600;${RATE}/0*1/60*2/90*2`);
    session.endDrag(false);
    expect(text()).toBe(`600;${RATE}/0*1/60*2`);
  });

  it('of the past are simulated again while paused, also after undo', async () => {
    const { stage, editor, session, seeks } = editing(`600;${RATE}/0*1/60*2`);
    stage.go(120);
    session.select(new Set([markOf(RATE, 60)]));
    session.move(5);
    session.move(5);
    expect(seeks).toEqual([]);
    session.settle();
    await expect.poll(() => seeks).toEqual([120]);
    editor.undo();
    await expect.poll(() => seeks).toEqual([120, 120]);
    stage.playing = true;
    editor.redo();
    await editor.delivered();
    expect(seeks).toEqual([120, 120]);
  });

  it('beyond the limits are reported', () => {
    const frames = Array.from({ length: 512 }, (_, step) => `${step}*1`).join('/');
    const { stage, session, said } = editing(`600;${RATE}/${frames}`);
    stage.go(550);
    session.toggleKeyframe(RATE);
    expect(said.at(-1)).toContain('1 could not be added.');
  });
});

describe('the playhead', () => {
  it('is in a round of a loop, and stays in it', async () => {
    const { stage, session, seeks } = editing(`120*loop;${RATE}/0*1/60*2`);
    stage.go(270);
    expect(session.step).toBe(30);
    await session.go(90);
    expect(seeks).toEqual([330]);
    session.goToMark(1);
    await expect.poll(() => seeks).toEqual([330, 300]);
  });
});

describe('recording', () => {
  it('makes a keyframe while paused, and leaves the value of the state', () => {
    const { stage, editor, session, text } = editing();
    session.recorder.isOn = true;
    stage.go(60);
    for (const rate of [50, 60, 70]) editor.change(RATE, rate, RATE);
    expect(editor.shown[RATE]).toBe(70);
    editor.settle();
    expect(text()).toBe(`600;${RATE}/0*40*e/60*70*e`);
    expect(editor.state.values[RATE]).toBe(40);
    editor.undo();
    expect(text()).toBe('');
    expect(editor.canUndo).toBe(false);
  });

  it('follows a gesture while playing, what it holds included, as one undo step', () => {
    const { stage, editor, session, text } = editing();
    session.recorder.isOn = true;
    stage.go(10);
    editor.change(RATE, 50, RATE);
    stage.play(30);
    editor.change(RATE, 100, RATE);
    stage.play(50);
    editor.settle();
    stage.play(60);
    expect(text()).toBe(`600;${RATE}/9*40/10*50/29*50/30*100/50*100*e`);
    editor.undo();
    expect(text()).toBe('');
  });

  it('records what has no gesture, and not items that are only being added', () => {
    const { editor, session, text } = editing();
    session.recorder.isOn = true;
    editor.changeAll({ 'vortices.5.circulation': 2 });
    expect(text()).toBe('');
    editor.reset(RATE);
    expect(text()).toMatch(/^600;emission\.rate\/0\*\d+\*e$/);
  });

  it('makes keyframes of gestures on the stage, as one undo step, and restores the value', async () => {
    const { stage, editor, session, text } = editing();
    session.recorder.isOn = true;
    stage.turn(20);
    stage.turn(30);
    editor.settle();
    await editor.delivered();
    expect(text()).toMatch(/^600;camera\.azimuth\/0\*30\*e$/);
    expect(stage.values['camera.azimuth']).toBeUndefined();
    editor.undo();
    await editor.delivered();
    expect(text()).toBe('');
    expect(editor.canUndo).toBe(false);
  });

  it('is off by default: a change by hand takes effect, even to the value of the state', () => {
    const { stage, editor, text } = editing(`600;${RATE}/0*1/60*2`);
    editor.change(RATE, 40, RATE);
    expect(stage.held).toEqual([{ [RATE]: 40 }]);
    editor.change(RATE, 90, RATE);
    editor.settle();
    expect([text(), editor.state.values[RATE]]).toEqual([`600;${RATE}/0*1/60*2`, 90]);
  });
});
