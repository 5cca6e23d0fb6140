import type { Stage } from '../../index.ts';
import {
  automaticColors,
  EMPTY_TIMELINE,
  MAX_STEP,
  readTimeline,
  timeIn,
  whyNotAnimated,
  writeTimeline,
  type Easing,
  type Lane,
  type Timeline,
  type TimelineBurst,
} from '../../internal.ts';
import { findParameter, type AnyValues, type Value } from '../../preset.ts';
import type { Changes, Editor } from '../editor/editor.ts';
import type { Scrubber } from '../playback/scrubber.ts';
import {
  allMarks,
  burstLane,
  burstOf,
  changed,
  copied,
  duplicated,
  existing,
  keyframeOf,
  marksOf,
  markOf,
  moved,
  pasted,
  placeOf,
  removed,
  stepsOf,
  STEPS_PER_SECOND,
  unitOf,
  valuesAt,
  withBurst,
  withKeyframe,
  withoutLane,
  type Clip,
  type Edit,
  type Grid,
  type Mark,
  type Marks,
} from './model.ts';
import { KeyframeRecorder, type Recorded } from './recorder.ts';
import { laneLabel, timeText, words } from './words.ts';

/** The parameter with the timeline as text. */
const KEY = 'timeline';
/** Puffs of a new burst. */
const BURST_COUNT = 24;
/** Distance of duplicates without beats, in seconds. */
const DUPLICATE_SECONDS = 0.5;

/** What the timeline acts on. */
export interface SessionParts {
  readonly editor: Editor;
  readonly stage: Stage;
  readonly scrubber: Scrubber;
}

/** The timeline of the page while it is edited: the playhead, what is selected, and all actions. */
export class Session implements Recorded {
  grid: Grid = { name: 'frames', rate: STEPS_PER_SECOND };
  readonly recorder = new KeyframeRecorder(this);
  /** Announces a sentence. */
  say: (sentence: string) => void = () => undefined;
  private readonly editor: Editor;
  private readonly stage: Stage;
  private readonly scrubber: Scrubber;
  private readonly listeners: (() => void)[] = [];
  private text: string | undefined;
  private read: Timeline = EMPTY_TIMELINE;
  private chosen: Marks = new Set();
  private current: Mark | undefined;
  private clip: Clip = [];
  /** Whether the past was edited since the smoke was simulated. */
  private needsUpdate = false;
  /** The timeline and the selection before a drag. */
  private before: { readonly timeline: Timeline; readonly marks: Marks; readonly copies: boolean } | undefined;

  constructor({ editor, stage, scrubber }: SessionParts) {
    this.editor = editor;
    this.stage = stage;
    this.scrubber = scrubber;
    editor.recorder = this.recorder;
    editor.listen((_state, changes) => {
      this.needsUpdate ||= KEY in changes;
      if (this.needsUpdate && editor.gesture === undefined) void this.update();
      this.notify();
    });
    stage.on('frame', () => this.holdRecorded());
    this.keepFocus();
  }

  /** @param listener called after each change of the timeline or of the selection */
  listen(listener: () => void): void {
    this.listeners.push(listener);
  }

  get timeline(): Timeline {
    const text = this.editor.state.values[KEY] ?? '';
    if (text !== this.text) this.read = readTimeline(text).timeline;
    this.text = text;
    return this.read;
  }

  get isEmpty(): boolean {
    const { lanes, bursts } = this.timeline;
    return lanes.length === 0 && bursts.length === 0;
  }

  /** Time of the playhead in steps of the timeline; a fraction while it plays. Without a loop it can be after the end. */
  get time(): number {
    const time = this.stage.stats.time * STEPS_PER_SECOND;
    return this.timeline.loops ? timeIn(this.timeline, time) : time;
  }

  get step(): number {
    return Math.round(this.time);
  }

  get values(): AnyValues {
    return this.editor.state.values;
  }

  get marks(): Marks {
    return this.chosen;
  }

  /** The mark that has the focus, or gets it. */
  get focused(): Mark | undefined {
    return this.current;
  }

  get canPaste(): boolean {
    return this.clip.length > 0;
  }

  /** The values in effect, those of the scene included. */
  get effective(): AnyValues {
    const { rig, shown } = this.stage;
    return { ...rig, ...automaticColors(this.editor.state.values), ...shown };
  }

  inEffect(key: string): Value | undefined {
    return this.effective[key];
  }

  holdSame(changes: Changes): void {
    const { values } = this;
    const same = Object.entries(changes).filter(
      ([key, value]) => value !== undefined && value === values[key] && this.laneOf(key),
    );
    if (same.length > 0) this.stage.set(Object.fromEntries(same));
  }

  /** Makes the panel of the parameters show what the timeline makes of them now. */
  showAnimated(): void {
    const shown: AnyValues = this.stage.shown;
    const entries = this.timeline.lanes.flatMap(({ key }) => (key in shown ? [[key, shown[key]] as const] : []));
    this.editor.animate(Object.fromEntries(entries));
  }

  /** Moves the playhead. @param step of the timeline */
  async go(step: number): Promise<void> {
    const { length, loops } = this.timeline;
    const rounds = loops ? Math.floor((this.stage.stats.time * STEPS_PER_SECOND) / length) : 0;
    await this.scrubber.go((rounds * length + Math.max(0, step)) / STEPS_PER_SECOND);
  }

  /** Moves the playhead to the next keyframe or burst, or to the previous one. */
  goToMark(way: 1 | -1): void {
    const { step } = this;
    const steps = allMarks(this.timeline).map((mark) => placeOf(mark).step);
    const others = steps.filter((each) => (way > 0 ? each > step : each < step));
    if (others.length > 0) void this.go(way > 0 ? Math.min(...others) : Math.max(...others));
  }

  select(marks: Marks, focused: Mark | undefined = this.current): void {
    this.chosen = existing(this.timeline, marks);
    this.current = focused;
    this.notify();
  }

  announceSelection(): void {
    this.say(words.chosen(this.chosen.size));
  }

  /** Adds a mark to the selection, or takes it out. */
  toggleSelected(mark: Mark): void {
    const marks = new Set(this.chosen);
    if (!marks.delete(mark)) marks.add(mark);
    this.select(marks, mark);
  }

  selectLane(lane: string): void {
    const marks = marksOf(this.timeline, lane);
    this.select(new Set(marks), marks[0]);
    this.announceSelection();
  }

  selectAll(): void {
    this.select(new Set(allMarks(this.timeline)));
    this.announceSelection();
  }

  /** Sets a keyframe with the value in effect, or removes the one there. */
  toggleKeyframe(key: string, step = this.step): void {
    const { label } = laneLabel(key);
    const why = whyNotAnimated(key);
    if (why !== undefined) return this.say(words.cannot(label, why));
    const mark = markOf(key, step);
    if (keyframeOf(this.timeline, mark)) return this.remove(new Set([mark]));
    const value = step === this.step ? this.inEffect(key) : valuesAt(this.timeline, step)[key];
    const easing = this.easingBefore(key, step);
    const keyframe = { step, value: value ?? this.inEffect(key) ?? findParameter(key)!.default, easing };
    this.apply(withKeyframe(this.timeline, key, keyframe), words.added(label, timeText(step, this.grid)));
  }

  addBurst(emitter = 0, step = this.step): void {
    const last = this.timeline.bursts.findLast((burst) => burst.emitter === emitter);
    const burst = { step, emitter, count: last?.count ?? BURST_COUNT };
    this.apply(withBurst(this.timeline, burst), words.burstAdded(timeText(step, this.grid)));
  }

  remove(marks = this.chosen): void {
    if (marks.size === 0) return;
    const next = this.neighbour(marks);
    const timeline = removed(this.timeline, marks);
    this.apply({ timeline, marks: next ? new Set([next]) : new Set(), leftOut: 0 }, words.removed(marks.size));
  }

  removeLane(lane: string): void {
    const { length } = stepsOf(this.timeline, lane);
    this.apply({ timeline: withoutLane(this.timeline, lane), marks: new Set(), leftOut: 0 }, words.removed(length));
  }

  copy(): void {
    if (this.chosen.size === 0) return;
    this.clip = copied(this.timeline, this.chosen);
    this.say(words.copied(this.clip.length));
    this.notify();
  }

  cut(): void {
    this.copy();
    this.remove();
  }

  /** Pastes at the playhead. */
  paste(): void {
    if (!this.canPaste) return;
    const edit = pasted(this.timeline, this.clip, this.step);
    this.apply(edit, words.pasted(edit.marks.size));
  }

  duplicate(): void {
    if (this.chosen.size === 0) return;
    const gap = this.grid.name === 'beats' ? unitOf(this.grid) : DUPLICATE_SECONDS * STEPS_PER_SECOND;
    const edit = duplicated(this.timeline, this.chosen, Math.round(gap));
    this.apply(edit, words.pasted(edit.marks.size));
  }

  /** Moves what is selected. Calls until `settle` are undone together. */
  move(steps: number): void {
    const focused = this.current && this.chosen.has(this.current) ? placeOf(this.current) : undefined;
    const before = [...this.chosen].map((mark) => placeOf(mark).step);
    const edit = moved(this.timeline, this.chosen, steps);
    const by = Math.min(...[...edit.marks].map((mark) => placeOf(mark).step)) - Math.min(...before);
    if (focused) this.current = markOf(focused.lane, focused.step + by);
    this.change(edit);
  }

  /** Moves one mark to a step, as an undo step of its own. The timeline gets longer if it must. */
  moveTo(mark: Mark, step: number): void {
    const to = Math.min(Math.max(0, step), MAX_STEP);
    const place = placeOf(mark);
    const length = Math.max(this.timeline.length, to);
    const { timeline, marks } = moved({ ...this.timeline, length }, new Set([mark]), to - place.step);
    this.current = markOf(place.lane, to);
    this.apply({ timeline, marks, leftOut: 0 }, words.moved(timeText(to, this.grid)));
  }

  setEasing(easing: Easing): void {
    this.change({ timeline: changed(this.timeline, this.chosen, { easing }), marks: this.chosen, leftOut: 0 });
  }

  setValue(value: Value): void {
    this.change({ timeline: changed(this.timeline, this.chosen, { value }), marks: this.chosen, leftOut: 0 });
  }

  setBurst(change: Partial<Omit<TimelineBurst, 'step'>>): void {
    const [mark] = this.chosen;
    const burst = burstOf(this.timeline, mark);
    if (!burst) return;
    const after = { ...burst, ...change };
    const rest = removed(this.timeline, this.chosen);
    this.current = markOf(burstLane(after.emitter), after.step);
    this.change(withBurst(rest, after));
  }

  /** @param length in steps */
  setLength(length: number): void {
    this.change({ timeline: { ...this.timeline, length }, marks: this.chosen, leftOut: 0 });
  }

  setLoops(loops: boolean): void {
    this.apply({ timeline: { ...this.timeline, loops }, marks: this.chosen, leftOut: 0 });
  }

  /** Begins a drag of what is selected. @param copies whether copies are dragged */
  beginDrag(copies: boolean): void {
    this.before = { timeline: this.timeline, marks: this.chosen, copies };
  }

  /** Drags what is selected. @param steps from where the drag began */
  drag(steps: number): void {
    if (!this.before) return;
    const { timeline, marks, copies } = this.before;
    const edit = copies ? this.copiedBy(steps) : moved(timeline, marks, steps);
    this.change(edit);
  }

  /** Ends a drag. @param isKept whether what was dragged stays at its new place */
  endDrag(isKept: boolean): void {
    if (!this.before) return;
    const { timeline, marks } = this.before;
    if (!isKept) this.change({ timeline, marks, leftOut: 0 });
    this.before = undefined;
    this.settle();
  }

  /** Ends a gesture. */
  settle(): void {
    this.editor.settle();
  }

  /** What follows from an edit of the past is only in smoke that is simulated again. */
  private async update(): Promise<void> {
    this.needsUpdate = false;
    await this.editor.delivered();
    if (!this.stage.playing) await this.scrubber.go(this.scrubber.wanted ?? this.stage.stats.time);
  }

  private copiedBy(steps: number): Edit {
    const { timeline, marks } = this.before!;
    const first = Math.min(...[...marks].map((mark) => placeOf(mark).step));
    if (steps === 0) return { timeline, marks, leftOut: 0 };
    return pasted(timeline, copied(timeline, marks), Math.max(0, first + steps));
  }

  /** An edit that is an undo step of its own. */
  private apply(edit: Edit, said?: string): void {
    this.settle();
    this.change(edit);
    this.settle();
    const all = [said, edit.leftOut > 0 ? words.full(edit.leftOut) : undefined].filter(Boolean);
    if (all.length > 0) this.say(all.join(' '));
  }

  /** An edit that is undone together with others of the same gesture. */
  private change({ timeline, marks }: Edit): void {
    this.chosen = marks;
    if (this.current === undefined || !marks.has(this.current)) this.current = [...marks][0] ?? this.current;
    const text = writeTimeline(timeline);
    if (text === this.text) return this.notify();
    this.editor.change(KEY, text, KEY);
  }

  /** The easing of a new keyframe: that of the one before it. */
  private easingBefore(key: string, step: number): Easing {
    return this.laneOf(key)?.keyframes.findLast((each) => each.step < step)?.easing ?? 'ease';
  }

  /** The mark that gets the focus after some are removed: the next one in the lane, or the previous one. */
  private neighbour(marks: Marks): Mark | undefined {
    const mark = this.current && marks.has(this.current) ? this.current : [...marks][0];
    const { lane, step } = placeOf(mark);
    const rest = marksOf(this.timeline, lane).filter((each) => !marks.has(each));
    return rest.find((each) => placeOf(each).step > step) ?? rest.at(-1);
  }

  /** Lets a mark have the focus that exists. */
  private keepFocus(): void {
    const all = allMarks(this.timeline);
    if (this.current === undefined || !all.includes(this.current)) this.current = all[0];
  }

  private laneOf(key: string): Lane | undefined {
    return this.timeline.lanes.find((lane) => lane.key === key);
  }

  /** Goes on recording the gesture in progress. */
  private holdRecorded(): void {
    const { gesture } = this.editor;
    if (!this.stage.playing || gesture === undefined) return;
    const text = this.recorder.hold();
    if (text !== undefined) this.editor.change(KEY, text, gesture);
  }

  private notify(): void {
    this.chosen = existing(this.timeline, this.chosen);
    this.keepFocus();
    for (const listener of this.listeners) listener();
  }
}
