/** Edits of timelines, as pure functions: select, move, copy, paste, snap and record. Times are in steps of 1/60 s. */
import {
  MAX_BURSTS,
  MAX_KEYFRAMES,
  MAX_LANES,
  MAX_STEP,
  valueAt,
  type Easing,
  type Keyframe,
  type Timeline,
  type TimelineBurst,
} from '../../internal.ts';
import { findParameter, table, type Value } from '../../preset.ts';

export const STEPS_PER_SECOND = 60;

/** A keyframe or a burst: the key of its lane and its step. The lane of an emitter's bursts is `burst.0` to `burst.7`. */
export type Mark = `${string}@${number}`;
export type Marks = ReadonlySet<Mark>;

/** A timeline after an edit, and what is then selected. */
export interface Edit {
  readonly timeline: Timeline;
  readonly marks: Marks;
  /** Number of keyframes and bursts that the limits of a timeline left out. */
  readonly leftOut: number;
}

/** Keyframes and bursts that were copied, the first one at step 0. */
export type Clip = readonly { readonly lane: string; readonly step: number; readonly item: Item }[];

/** Steps per unit of the grid that edits snap to; may be a fraction. */
export type Grid =
  { readonly name: 'frames'; readonly rate: number } | { readonly name: 'beats'; readonly bpm: number };

type Item = Keyframe | TimelineBurst;
/** The items of each lane by step. */
type Tracks = Map<string, Map<number, Item>>;

const BURSTS = 'burst.';
/** Places in the table. */
const ORDER: ReadonlyMap<string, number> = new Map(table.map(({ key }, place) => [key, place]));

export function markOf(lane: string, step: number): Mark {
  return `${lane}@${step}`;
}

export function placeOf(mark: Mark): { readonly lane: string; readonly step: number } {
  const at = mark.lastIndexOf('@');
  return { lane: mark.slice(0, at), step: Number(mark.slice(at + 1)) };
}

/** The lane of an emitter's bursts. */
export function burstLane(emitter: number): string {
  return BURSTS + emitter;
}

/** The emitter of a lane of bursts; undefined for the lane of a parameter. */
export function emitterOf(lane: string): number | undefined {
  return lane.startsWith(BURSTS) ? Number(lane.slice(BURSTS.length)) : undefined;
}

/** The lanes in the order of the table, then those of bursts. */
export function laneNames({ lanes, bursts }: Timeline): readonly string[] {
  const keys = lanes.map(({ key }) => key).toSorted((a, b) => ORDER.get(a)! - ORDER.get(b)!);
  const emitters = [...new Set(bursts.map(({ emitter }) => emitter))].toSorted((a, b) => a - b);
  return [...keys, ...emitters.map(burstLane)];
}

/** The steps of a lane's keyframes or bursts, in order. */
export function stepsOf(timeline: Timeline, lane: string): readonly number[] {
  const emitter = emitterOf(lane);
  if (emitter === undefined)
    return timeline.lanes.find(({ key }) => key === lane)?.keyframes.map(({ step }) => step) ?? [];
  return timeline.bursts.flatMap((burst) => (burst.emitter === emitter ? [burst.step] : []));
}

export function marksOf(timeline: Timeline, lane: string): readonly Mark[] {
  return stepsOf(timeline, lane).map((step) => markOf(lane, step));
}

export function allMarks(timeline: Timeline): readonly Mark[] {
  return laneNames(timeline).flatMap((lane) => marksOf(timeline, lane));
}

/** Those of the marks that the timeline has. */
export function existing(timeline: Timeline, marks: Iterable<Mark>): Marks {
  const all = new Set(allMarks(timeline));
  return new Set([...marks].filter((mark) => all.has(mark)));
}

/** The keyframe of a mark; undefined for a burst and for none. */
export function keyframeOf({ lanes }: Timeline, mark: Mark): Keyframe | undefined {
  const { lane, step } = placeOf(mark);
  return lanes.find(({ key }) => key === lane)?.keyframes.find((keyframe) => keyframe.step === step);
}

/** The burst of a mark; undefined for a keyframe and for none. */
export function burstOf({ bursts }: Timeline, mark: Mark): TimelineBurst | undefined {
  const { lane, step } = placeOf(mark);
  return bursts.find((burst) => burst.emitter === emitterOf(lane) && burst.step === step);
}

/** The last step with a keyframe or a burst, or the end if it is later. */
export function lastStep({ length, lanes, bursts }: Timeline): number {
  const steps = [...lanes.flatMap(({ keyframes }) => keyframes), ...bursts].map(({ step }) => step);
  return Math.max(length, ...steps);
}

/** The values of all animated parameters. @param time in steps from the start; may be a fraction */
export function valuesAt({ lanes }: Timeline, time: number): Record<string, Value> {
  return Object.fromEntries(lanes.map((lane) => [lane.key, valueAt(lane, time)]));
}

/** Moves marks together as far as the start and the end let them. Others at their new steps are replaced. */
export function moved(timeline: Timeline, marks: Marks, steps: number): Edit {
  const places = [...marks].map(placeOf);
  const [first, last] = [Math.min(...places.map(({ step }) => step)), Math.max(...places.map(({ step }) => step))];
  // What is after the end already does not come back by a move to the left of something else.
  const by = Math.max(-first, Math.min(steps, Math.max(timeline.length - last, 0)));
  if (by === 0 || places.length === 0) return { timeline, marks, leftOut: 0 };
  const tracks = tracksOf(timeline);
  const items = places.map(({ lane, step }) => ({ lane, step: step + by, item: tracks.get(lane)!.get(step)! }));
  for (const { lane, step } of places) tracks.get(lane)!.delete(step);
  return inserted(timeline, tracks, items);
}

export function removed(timeline: Timeline, marks: Marks): Timeline {
  const tracks = tracksOf(timeline);
  for (const { lane, step } of [...marks].map(placeOf)) tracks.get(lane)?.delete(step);
  return withTracks(timeline, tracks);
}

export function copied(timeline: Timeline, marks: Marks): Clip {
  const places = [...marks].map(placeOf).toSorted((a, b) => a.step - b.step);
  const tracks = tracksOf(timeline);
  return places.map(({ lane, step }) => ({ lane, step: step - places[0].step, item: tracks.get(lane)!.get(step)! }));
}

/** Inserts a clip at a step. The timeline gets longer if it must. Others at the same steps are replaced. */
export function pasted(timeline: Timeline, clip: Clip, at: number): Edit {
  const items = clip.map(({ lane, step, item }) => ({ lane, step: step + at, item }));
  return inserted(timeline, tracksOf(timeline), items);
}

/** Copies marks to just behind themselves. @param gap steps from the last one to the first copy */
export function duplicated(timeline: Timeline, marks: Marks, gap: number): Edit {
  const last = Math.max(...[...marks].map((mark) => placeOf(mark).step));
  return pasted(timeline, copied(timeline, marks), last + gap);
}

/** Marks within a box. @param lanes those that the box touches @param from, to steps, in any order */
export function boxed(timeline: Timeline, lanes: readonly string[], from: number, to: number): Marks {
  const [first, last] = [Math.min(from, to), Math.max(from, to)];
  const isWithin = (mark: Mark) => placeOf(mark).step >= first && placeOf(mark).step <= last;
  return new Set(lanes.flatMap((lane) => marksOf(timeline, lane)).filter(isWithin));
}

/** Sets a keyframe, and replaces the one at its step. The timeline gets longer if it must. */
export function withKeyframe(timeline: Timeline, key: string, keyframe: Keyframe): Edit {
  return inserted(timeline, tracksOf(timeline), [{ lane: key, step: keyframe.step, item: keyframe }]);
}

/** Sets a burst, and replaces the one of its emitter at its step. The timeline gets longer if it must. */
export function withBurst(timeline: Timeline, burst: TimelineBurst): Edit {
  return inserted(timeline, tracksOf(timeline), [{ lane: burstLane(burst.emitter), step: burst.step, item: burst }]);
}

/** Changes the value or the easing of keyframes, or the count of bursts. */
export function changed(
  timeline: Timeline,
  marks: Marks,
  change: { readonly value?: Value; readonly easing?: Easing; readonly count?: number },
): Timeline {
  const { count, ...ofKeyframe } = change;
  const isMarked = (lane: string, step: number) => marks.has(markOf(lane, step));
  const lanes = timeline.lanes.map(({ key, keyframes }) => ({
    key,
    keyframes: keyframes.map((each) => (isMarked(key, each.step) ? { ...each, ...ofKeyframe } : each)),
  }));
  const bursts = timeline.bursts.map((burst) =>
    count !== undefined && isMarked(burstLane(burst.emitter), burst.step) ? { ...burst, count } : burst,
  );
  return { ...timeline, lanes, bursts };
}

export function withoutLane(timeline: Timeline, lane: string): Timeline {
  return removed(timeline, new Set(marksOf(timeline, lane)));
}

/** Steps between two lines of a grid; may be a fraction. */
export function unitOf(grid: Grid): number {
  return STEPS_PER_SECOND / (grid.name === 'frames' ? grid.rate : grid.bpm / 60);
}

/** The whole step nearest to the grid line that is nearest to a time. */
export function snapped(time: number, grid: Grid): number {
  const unit = unitOf(grid);
  return Math.min(Math.max(0, Math.round(Math.round(time / unit) * unit)), MAX_STEP);
}

/** The step of the next line of a grid, or of an earlier one. @param way lines forwards, negative backwards */
export function onGrid(step: number, way: number, grid: Grid): number {
  const unit = unitOf(grid);
  // A step that was rounded from a line counts as that line.
  const line = Math.round(step / unit);
  const isOnLine = Math.round(line * unit) === step;
  const next = isOnLine ? line + way : way > 0 ? Math.ceil(step / unit) + way - 1 : Math.floor(step / unit) + way + 1;
  return Math.min(Math.max(0, Math.round(next * unit)), MAX_STEP);
}

/** A change while recording: the value of a parameter at a step. */
export interface Sample {
  readonly step: number;
  readonly value: Value;
}

/** Largest deviation of a thinned recording, as a share of the range of its numbers, or of a colour channel. */
const TOLERANCE = 0.01;

/**
 * Makes keyframes of what was recorded. They replace those between the first and the last sample. Between samples that
 * lie on a straight line no keyframe is needed.
 * @param before the value before the recording, which a new lane keeps up to the first sample
 */
export function recorded(timeline: Timeline, key: string, samples: readonly Sample[], before: Value): Edit {
  const [from, to] = [samples[0].step, samples[samples.length - 1].step];
  const kept = thinned(key, samples, distanceWithin(key, samples));
  const lane = timeline.lanes.find((each) => each.key === key);
  const start = !lane && from > 0 ? [startOf(samples, before)] : [];
  const between = boxed(timeline, [key], from, to);
  const easing = (step: number): Easing =>
    step < to ? 'linear' : (lane?.keyframes.findLast((each) => each.step <= to)?.easing ?? 'ease');
  const keyframes = [...start, ...kept.map(({ step, value }) => ({ step, value, easing: easing(step) }))];
  const rest = tracksOf(removed(timeline, between));
  return inserted(
    timeline,
    rest,
    keyframes.map((item) => ({ lane: key, step: item.step, item })),
  );
}

/** The keyframe with the old value: at the start for a change while paused, just before a recorded gesture otherwise. */
function startOf(samples: readonly Sample[], value: Value): Keyframe {
  const step = samples.length > 1 ? samples[0].step - 1 : 0;
  return { step, value, easing: samples.length > 1 ? 'linear' : 'ease' };
}

/** How different two values are, 0 to 1. */
type Distance = (a: Value, b: Value) => number;

/** The samples that linear keyframes need (Ramer, Douglas and Peucker). */
function thinned(key: string, samples: readonly Sample[], distance: Distance): readonly Sample[] {
  if (samples.length <= 2) return samples;
  const [first, last] = [samples[0], samples[samples.length - 1]];
  const ends = [first, last].map((sample): Keyframe => ({ ...sample, easing: 'linear' }));
  const away = samples.map(({ step, value }) => distance(value, valueAt({ key, keyframes: ends }, step)));
  const farthest = away.indexOf(Math.max(...away.slice(1, -1)), 1);
  if (away[farthest] <= TOLERANCE) return [first, last];
  const before = thinned(key, samples.slice(0, farthest + 1), distance);
  return [...before, ...thinned(key, samples.slice(farthest), distance).slice(1)];
}

/** Values that cannot be blended are equal or not. */
function distanceWithin(key: string, samples: readonly Sample[]): Distance {
  const { kind } = findParameter(key)!;
  if (kind === 'number' || kind === 'integer') {
    const values = samples.map(({ value }) => Number(value));
    const range = Math.max(...values) - Math.min(...values);
    return (a, b) => (range === 0 ? 0 : Math.abs(Number(a) - Number(b)) / range);
  }
  return kind === 'color' ? colorDistance : (a, b) => (a === b ? 0 : 1);
}

function colorDistance(a: Value, b: Value): number {
  const channels = [1, 3, 5].map((at) => [a, b].map((color) => Number.parseInt(String(color).slice(at, at + 2), 16)));
  return Math.max(...channels.map(([one, other]) => Math.abs(one - other))) / 255;
}

function tracksOf({ lanes, bursts }: Timeline): Tracks {
  const tracks: Tracks = new Map();
  const add = (lane: string, item: Item) => {
    if (!tracks.has(lane)) tracks.set(lane, new Map());
    tracks.get(lane)!.set(item.step, item);
  };
  for (const { key, keyframes } of lanes) for (const keyframe of keyframes) add(key, keyframe);
  for (const burst of bursts) add(burstLane(burst.emitter), burst);
  return tracks;
}

function withTracks(timeline: Timeline, tracks: Tracks): Timeline {
  const inOrder = (items: Iterable<Item>) => [...items].toSorted((a, b) => a.step - b.step);
  const lanes = [...tracks].flatMap(([key, items]) =>
    emitterOf(key) === undefined && items.size > 0 ? [{ key, keyframes: inOrder(items.values()) as Keyframe[] }] : [],
  );
  const bursts = [...tracks].flatMap(([lane, items]) => {
    const emitter = emitterOf(lane);
    return emitter === undefined ? [] : [...items.values()].map((item) => ({ ...(item as TimelineBurst), emitter }));
  });
  return { ...timeline, lanes, bursts: bursts.toSorted((a, b) => a.step - b.step || a.emitter - b.emitter) };
}

/** Adds items, as far as the limits of a timeline allow, and makes it as long as they need. */
function inserted(timeline: Timeline, tracks: Tracks, items: Clip): Edit {
  const marks = new Set<Mark>();
  const counts = countsOf(tracks);
  let length = timeline.length;
  for (const { lane, step, item } of items) {
    const track = tracks.get(lane);
    if (step > MAX_STEP || (!track?.has(step) && !hasRoom(lane, track?.size ?? 0, counts))) continue;
    if (!track?.has(step)) grow(lane, track?.size ?? 0, counts);
    if (!track) tracks.set(lane, new Map());
    tracks.get(lane)!.set(step, { ...item, step });
    marks.add(markOf(lane, step));
    length = Math.max(length, step);
  }
  return { timeline: withTracks({ ...timeline, length }, tracks), marks, leftOut: items.length - marks.size };
}

interface Counts {
  lanes: number;
  keyframes: number;
  bursts: number;
}

function countsOf(tracks: Tracks): Counts {
  const counts = { lanes: 0, keyframes: 0, bursts: 0 };
  for (const [lane, { size }] of tracks) {
    if (emitterOf(lane) !== undefined) counts.bursts += size;
    else if (size > 0) {
      counts.lanes += 1;
      counts.keyframes += size;
    }
  }
  return counts;
}

function hasRoom(lane: string, size: number, { lanes, keyframes, bursts }: Counts): boolean {
  if (emitterOf(lane) !== undefined) return bursts < MAX_BURSTS;
  return keyframes < MAX_KEYFRAMES && (size > 0 || lanes < MAX_LANES);
}

function grow(lane: string, size: number, counts: Counts): void {
  if (emitterOf(lane) !== undefined) counts.bursts += 1;
  else {
    counts.keyframes += 1;
    if (size === 0) counts.lanes += 1;
  }
}
