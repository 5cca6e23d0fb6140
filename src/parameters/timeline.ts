/**
 * Timelines: keyframes of parameters by step, and bursts of emitters at steps. The same numbers come out in every engine,
 * because only + - * / and the exact members of Math are used.
 *
 * As text: `720*loop;emission.rate/0*60/120*240*e;style.smokeColor/0*ffffff/60*ff8800*h;burst/60*0*24`. The parts are the
 * length in steps; for each parameter its key and its keyframes, `step*value` or `step*value*easing`; and the bursts,
 * `step*emitter*count`. Easings are `h`, `e`, `i`, `o` or four numbers with commas between them; linear without one.
 */
import { ParameterError } from '../base/errors.ts';
import { readCurve, writeCurve } from './curve.ts';
import { LIST_LIMIT } from './lists.ts';
import { notice, type Notice } from './notice.ts';
import { accepted, TIMELINE_LIMIT, type AnyValues, type Parameter, type Value, type Values } from './parameter.ts';
import { readPath, writePath, type PathPoint } from './path.ts';
import { readRamp, writeRamp } from './ramp.ts';
import { findParameter } from './table.ts';
import { isAccepted, readText, writeText } from './values.ts';

/**
 * How a lane goes from a keyframe to the next: constant, straight, or a cubic Bezier curve in time and value from (0, 0)
 * to (1, 1) with two handles; x from 0 to 1, y from -2 to 3. `ease` starts and ends slowly, `easeIn` starts slowly,
 * `easeOut` ends slowly.
 */
export type Easing =
  'hold' | 'linear' | 'ease' | 'easeIn' | 'easeOut' | readonly [x1: number, y1: number, x2: number, y2: number];

/** The value of a parameter at a step. */
export interface Keyframe {
  /** Whole steps of 1/60 s from the start, 0 to 36,000. */
  readonly step: number;
  readonly value: Value;
  /** Until the next keyframe. */
  readonly easing: Easing;
}

/** The keyframes of a parameter. Before the first and after the last one its value is constant. */
export interface Lane {
  readonly key: string;
  /** At least one, sorted by step, at most one at a step. */
  readonly keyframes: readonly Keyframe[];
}

/** Puffs that an emitter of the table emits at once. */
export interface TimelineBurst {
  /** Whole steps of 1/60 s from the start, 0 to 36,000. */
  readonly step: number;
  /** Index in the table, 0 to 7. */
  readonly emitter: number;
  /** Number of puffs, 1 to 20,000. */
  readonly count: number;
}

/** Values and bursts over time. At the end it starts again or stays as it is; the simulation goes on. */
export interface Timeline {
  /** Whole steps of 1/60 s, 1 to 36,000. */
  readonly length: number;
  readonly loops: boolean;
  /** At most 64, one for a parameter, with at most 512 keyframes in all. */
  readonly lanes: readonly Lane[];
  /** At most 256, sorted by step and emitter. */
  readonly bursts: readonly TimelineBurst[];
}

/** Values in which the timeline may also be an object. */
export type GivenValues = Omit<Values, 'timeline'> & { readonly timeline?: string | Timeline };

/** The grammar of timelines as text. Keys and values have further limits. */
export const TIMELINE = /^(\d{1,5}(\*loop)?(;[\w.]+(\/[\w*.,:-]+)+)*)?$/;

export const MAX_LANES = 64;
/** Of all lanes together. */
export const MAX_KEYFRAMES = 512;
export const MAX_BURSTS = 256;
/** Last step of a keyframe, and the greatest length: ten minutes. */
export const MAX_STEP = 36_000;
const MAX_COUNT = 20_000;
const DEFAULT_LENGTH = 600;
/** In place of a key, as text. */
const BURST = 'burst';

/** Without lanes and bursts; ten seconds long. */
export const EMPTY_TIMELINE: Timeline = { length: DEFAULT_LENGTH, loops: false, lanes: [], bursts: [] };

const LETTERS = { hold: 'h', ease: 'e', easeIn: 'i', easeOut: 'o' } as const;
/** Handles of the named easings. */
export const CURVES = { ease: [0.42, 0, 0.58, 1], easeIn: [0.42, 0, 1, 1], easeOut: [0, 0, 0.58, 1] } as const;
const EASINGS: readonly unknown[] = ['linear', ...Object.keys(LETTERS)];
/** Range of the coordinates of handles. */
const HANDLE = { x: [0, 1], y: [-2, 3] } as const;

const OF_STEP = `a whole step from 0 to ${MAX_STEP}`;
const OF_LENGTH = `whole steps from 1 to ${MAX_STEP}`;
const OF_EASING = `${EASINGS.join(', ')}, or x1,y1,x2,y2 with x from 0 to 1 and y from -2 to 3`;
const OF_BURST = `a step from 0 to ${MAX_STEP}, an emitter from 0 to ${LIST_LIMIT - 1} and a count from 1 to ${MAX_COUNT}`;

/** Reports what is wrong: the place in the timeline, what was given and what is accepted. */
type Report = (place: string, given: unknown, accepts: string) => void;

/** Why the parameter of a key cannot be animated, as a sentence; undefined if it can. */
export function whyNotAnimated(key: string): string | undefined {
  const row = findParameter(key);
  if (!row) return `There is no parameter ${key}.`;
  if (row.reader === 'stage') return 'It belongs to the whole smoke and cannot change over time.';
  if (row.fixed === 'puffs' || row.kind === 'drawing') return 'A change makes new puff shapes, which takes too long.';
  if (row.fixed === 'shaders') return 'A change compiles other shaders, which takes too long.';
  if (row.fixed === 'looks') return 'Puffs keep the look of their birth, and there are at most 15 looks at a time.';
  return row.fixed && 'It selects how the smoke is simulated and cannot change over time.';
}

/**
 * Reads a timeline of a link or a file. Never throws: what cannot be used is left out or clamped.
 * @returns the timeline, and a sentence for each part that was left out or changed
 */
export function readTimeline(text: string): { timeline: Timeline; problems: string[] } {
  const problems: string[] = [];
  const report: Report = (place, given, accepts) => {
    problems.push(`${place} cannot be \u201c${shortened(given)}\u201d: it takes ${accepts}.`);
  };
  return { timeline: parse(text, report), problems };
}

/**
 * Reads a timeline of a link, a file or an attribute.
 * @param notices receives one for each part that is left out or changed
 * @returns what is left of it, as text
 */
export function cleanTimeline(text: string, notices: Notice[]): string {
  const { timeline, problems } = readTimeline(text);
  notices.push(...problems.map((problem) => notice('malformed', 'timeline', text, () => problem)));
  return writeTimeline(timeline);
}

/**
 * Formats a timeline for links and files.
 * @returns an empty text for {@link EMPTY_TIMELINE}
 */
export function writeTimeline({ length, loops, lanes, bursts }: Timeline): string {
  const head = loops ? `${length}*loop` : String(length);
  const parts = [head, ...lanes.map(laneText), ...(bursts.length > 0 ? [burstsText(bursts)] : [])];
  const text = parts.join(';');
  return text === String(DEFAULT_LENGTH) ? '' : text;
}

/**
 * The timeline that a caller gives, as text or as an object.
 * @throws ParameterError for the first part that is invalid
 */
export function requireTimeline(given: unknown): Timeline {
  const report: Report = (place, value, accepts) => {
    throw new ParameterError(place, typeof value === 'object' ? 'an object' : value, accepts);
  };
  if (typeof given === 'string') return parse(given, report);
  const timeline = fromObject(given, report);
  const { length } = writeTimeline(timeline);
  if (length > TIMELINE_LIMIT) report('timeline', length, `at most ${TIMELINE_LIMIT} characters as text`);
  return timeline;
}

/**
 * A timeline with keyframes of these values at a step, in place of those there. A new keyframe continues as the one before
 * it does; parameters without a lane get one.
 * @param step simulated
 * @throws ParameterError for a parameter that cannot be animated, an invalid value, and beyond the limits
 */
export function withKeyframes(timeline: Timeline, values: AnyValues, step: number): Timeline {
  const at = Math.min(timeIn(timeline, step), MAX_STEP);
  const lanes = new Map(timeline.lanes.map(({ key, keyframes }) => [key, keyframes]));
  for (const [key, value] of Object.entries(values)) {
    const others = (lanes.get(key) ?? []).filter((keyframe) => keyframe.step !== at);
    const easing = (lanes.get(key) ?? []).findLast((keyframe) => keyframe.step <= at)?.easing ?? 'linear';
    lanes.set(key, [...others, { step: at, value, easing }]);
  }
  return requireTimeline({ ...timeline, lanes: [...lanes].map(([key, keyframes]) => ({ key, keyframes })) });
}

/**
 * Time on a timeline, in steps from its start.
 * @param time simulated, in steps; may be a fraction
 */
export function timeIn({ length, loops }: Pick<Timeline, 'length' | 'loops'>, time: number): number {
  if (time < length) return time;
  return loops ? time - Math.floor(time / length) * length : length;
}

/** @param time in steps from the start of the timeline; may be a fraction, for drawing */
export function valueAt({ key, keyframes }: Lane, time: number): Value {
  const next = keyframes.findIndex(({ step }) => step > time);
  const from = keyframes[next < 0 ? keyframes.length - 1 : Math.max(0, next - 1)];
  if (next < 1 || from.easing === 'hold') return from.value;
  const to = keyframes[next];
  return blended(
    findParameter(key)!,
    from.value,
    to.value,
    eased(from.easing, (time - from.step) / (to.step - from.step)),
  );
}

/** Share of the way from a keyframe to the next. @param share of the time, 0..1 */
export function eased(easing: Easing, share: number): number {
  if (easing === 'hold') return 0;
  if (easing === 'linear' || share === 0) return share;
  const [x1, y1, x2, y2] = typeof easing === 'string' ? CURVES[easing] : easing;
  const [a, b, c] = coefficients(x1, x2);
  // The steps of Newton that stay between bounds, otherwise bisection: x rises.
  let [low, high, at] = [0, 1, share];
  for (let turn = 0; turn < 12; ++turn) {
    const beyond = ((a * at + b) * at + c) * at - share;
    if (beyond < 0) low = at;
    else high = at;
    const next = at - beyond / ((3 * a * at + 2 * b) * at + c);
    at = next >= low && next <= high ? next : (low + high) / 2;
  }
  const [d, e, f] = coefficients(y1, y2);
  return ((d * at + e) * at + f) * at;
}

/** Of the cubic polynomial that a Bezier curve from 0 to 1 is. */
function coefficients(first: number, second: number): readonly [cubed: number, squared: number, plain: number] {
  return [1 + 3 * (first - second), 3 * (second - 2 * first), 3 * first];
}

/** The value between two, as far as the kind of the parameter has one; otherwise the first. */
function blended(row: Parameter, from: Value, to: Value, share: number): Value {
  if (row.kind === 'number') return clamped(mixed(Number(from), Number(to), share), row.min, row.max);
  if (row.kind === 'integer') return Math.round(clamped(mixed(Number(from), Number(to), share), row.min, row.max));
  if (row.kind === 'color') return mixedColor(String(from), String(to), share);
  // Places of stops keep their order within 0..1 only.
  if (row.kind === 'curve') return mixedCurve(String(from), String(to), clamped(share, 0, 1));
  if (row.kind === 'path') return mixedPath(String(from), String(to), clamped(share, 0, 1));
  if (row.kind === 'ramp') return mixedRamp(String(from), String(to), clamped(share, 0, 1));
  return from;
}

function mixedCurve(from: string, to: string, share: number): string {
  const [a, b] = [readCurve(from)!, readCurve(to)!];
  if (a.length !== b.length) return from;
  const text = writeCurve(
    a.map(({ at, value }, stop) => ({ at: mixed(at, b[stop].at, share), value: mixed(value, b[stop].value, share) })),
  );
  // Stops closer than the written decimals would have one place.
  return readCurve(text) ? text : from;
}

function mixedPath(from: string, to: string, share: number): string {
  const [a, b] = [readPath(from), readPath(to)];
  if (a.length !== b.length) return from;
  return writePath(
    a.map((point, index) => point.map((part, axis) => mixed(part, b[index][axis], share)) as unknown as PathPoint),
  );
}

function mixedRamp(from: string, to: string, share: number): string {
  const [a, b] = [readRamp(from)!, readRamp(to)!];
  if (a.length !== b.length) return from;
  const text = writeRamp(
    a.map(({ at, color }, stop) => ({
      at: mixed(at, b[stop].at, share),
      color: mixedColor(color, b[stop].color, share),
    })),
  );
  return readRamp(text) ? text : from;
}

function mixedColor(from: string, to: string, share: number): string {
  const channels = [1, 3, 5].map((place) => {
    const [a, b] = [from, to].map((color) => Number.parseInt(color.slice(place, place + 2), 16));
    return Math.round(clamped(mixed(a, b, share), 0, 255));
  });
  return `#${channels.map((channel) => channel.toString(16).padStart(2, '0')).join('')}`;
}

function mixed(from: number, to: number, share: number): number {
  // Exact at both ends.
  return share === 1 ? to : from + share * (to - from);
}

function clamped(value: number, min: number, max: number): number {
  return Math.min(Math.max(value, min), max);
}

function laneText({ key, keyframes }: Lane): string {
  const row = findParameter(key)!;
  const frames = keyframes.map(({ step, value, easing }) => `${step}*${writeText(row, value)}${easingText(easing)}`);
  return [key, ...frames].join('/');
}

function easingText(easing: Easing): string {
  if (easing === 'linear') return '';
  return `*${typeof easing === 'string' ? LETTERS[easing] : easing.join(',')}`;
}

function burstsText(bursts: readonly TimelineBurst[]): string {
  return [BURST, ...bursts.map(({ step, emitter, count }) => `${step}*${emitter}*${count}`)].join('/');
}

function parse(text: string, report: Report): Timeline {
  if (text.length > TIMELINE_LIMIT) report('timeline', text, `at most ${TIMELINE_LIMIT} characters`);
  const [head, ...parts] = text.slice(0, TIMELINE_LIMIT).split(';');
  const [length, loop, ...others] = head.split('*');
  if (others.length > 0 || (loop !== undefined && loop !== 'loop')) report('timeline', head, `${OF_LENGTH}, and *loop`);
  const builder = new Builder(report);
  for (const part of parts) {
    const [key, ...frames] = part.split('/');
    if (key === BURST) for (const frame of frames) builder.addBurst(frame, frame.split('*').map(wholeOf));
    else
      builder.addLane(
        key,
        frames.map((frame) => (row: Parameter) => parsedKeyframe(row, frame, report)),
      );
  }
  return builder.build(head === '' ? DEFAULT_LENGTH : wholeOf(length), loop === 'loop');
}

/** A keyframe in text; undefined if it cannot be used. */
function parsedKeyframe(row: Parameter, text: string, report: Report): Keyframe | undefined {
  const [step, value = '', easing, ...others] = text.split('*');
  const read = readText(row, value);
  if (others.length > 0 || read.notice?.code === 'malformed') {
    report(placeOf(row.key), others.length > 0 ? text : value, accepted(row));
    return undefined;
  }
  if (read.notice) report(placeOf(row.key), value, accepted(row));
  return { step: wholeOf(step), value: read.value, easing: parsedEasing(easing) };
}

/** A whole number in text; the text itself if it is none. */
function wholeOf(text: string): number {
  return (/^\d{1,9}$/.test(text) ? Number(text) : text) as number;
}

/** An easing in text; the text itself if it is none. */
function parsedEasing(text: string | undefined): Easing {
  if (text === undefined) return 'linear';
  const named = Object.entries(LETTERS).find(([, letter]) => letter === text)?.[0];
  const numbers = text.split(',').map((part) => (part.trim() === '' ? Number.NaN : Number(part)));
  return (named ?? (numbers.length === 4 ? numbers : text)) as Easing;
}

/** A timeline in an object of a caller, which may be any value of JavaScript. */
function fromObject(given: unknown, report: Report): Timeline {
  const { length, loops = false, lanes = [], bursts = [] } = recordOf(given, 'timeline', report);
  if (typeof loops !== 'boolean') report('timeline.loops', loops, 'true or false');
  const builder = new Builder(report);
  for (const lane of listOf(lanes, 'timeline.lanes', MAX_LANES, report)) {
    const { key, keyframes } = recordOf(lane, 'timeline.lanes', report);
    if (typeof key !== 'string') report('timeline.lanes.key', key, 'the key of a parameter');
    const frames = listOf(keyframes, placeOf(String(key)), MAX_KEYFRAMES, report);
    builder.addLane(
      String(key),
      frames.map((frame) => (row: Parameter) => givenKeyframe(row, frame, report)),
    );
  }
  for (const burst of listOf(bursts, 'timeline.bursts', MAX_BURSTS, report)) {
    const { step, emitter, count } = recordOf(burst, 'timeline.bursts', report);
    builder.addBurst(burst, [step, emitter, count] as number[]);
  }
  return builder.build(length as number, loops as boolean);
}

function givenKeyframe(row: Parameter, frame: unknown, report: Report): Keyframe {
  const { step, value, easing = 'linear' } = recordOf(frame, placeOf(row.key), report);
  if (!isAccepted(row, value)) report(placeOf(row.key), value, accepted(row));
  return { step, value, easing: Array.isArray(easing) ? [...easing] : easing } as Keyframe;
}

function recordOf(value: unknown, place: string, report: Report): Record<string, unknown> {
  if (typeof value !== 'object' || value === null) report(place, value, 'an object');
  return value as Record<string, unknown>;
}

function listOf(value: unknown, place: string, most: number, report: Report): readonly unknown[] {
  if (!Array.isArray(value) || value.length > most) report(place, value, `a list of at most ${most}`);
  return value as readonly unknown[];
}

/** Checks and collects the parts of a timeline. */
class Builder {
  private readonly report: Report;
  private readonly lanes: Lane[] = [];
  private readonly bursts: TimelineBurst[] = [];
  private keyframes = 0;

  constructor(report: Report) {
    this.report = report;
  }

  /** @param frames make a keyframe of the lane's parameter, or none */
  addLane(key: string, frames: readonly ((row: Parameter) => Keyframe | undefined)[]): void {
    const reason = whyNotAnimated(key);
    if (reason) return this.report(placeOf(key), 'animated', `no keyframes. ${reason}`.replace(/\.$/, ''));
    if (this.lanes.some((lane) => lane.key === key)) return this.report(placeOf(key), key, 'one lane for a parameter');
    if (this.lanes.length === MAX_LANES) return this.report(placeOf(key), key, `at most ${MAX_LANES} lanes`);
    const row = findParameter(key)!;
    const keyframes: Keyframe[] = [];
    for (const make of frames) {
      const keyframe = make(row);
      if (keyframe && this.isUsable(key, keyframe, keyframes)) keyframes.push(keyframe);
    }
    if (keyframes.length === 0) return this.report(placeOf(key), 'empty', 'at least one keyframe');
    this.keyframes += keyframes.length;
    this.lanes.push({ key, keyframes: keyframes.sort((a, b) => a.step - b.step) });
  }

  addBurst(given: unknown, [step, emitter, count, ...others]: readonly number[]): void {
    const isRight =
      isWhole(step, 0, MAX_STEP) &&
      isWhole(emitter, 0, LIST_LIMIT - 1) &&
      isWhole(count, 1, MAX_COUNT) &&
      others.length === 0;
    if (!isRight) return this.report('timeline.bursts', given, OF_BURST);
    if (this.bursts.length === MAX_BURSTS) return this.report('timeline.bursts', given, `at most ${MAX_BURSTS} bursts`);
    if (this.bursts.some((burst) => burst.step === step && burst.emitter === emitter))
      return this.report('timeline.bursts', given, 'one burst of an emitter at a step');
    this.bursts.push({ step, emitter, count });
  }

  build(length: number, loops: boolean): Timeline {
    const isRight = isWhole(length, 1, MAX_STEP);
    if (!isRight) this.report('timeline.length', length, OF_LENGTH);
    const bursts = this.bursts.sort((a, b) => a.step - b.step || a.emitter - b.emitter);
    return { length: isRight ? length : DEFAULT_LENGTH, loops, lanes: this.lanes, bursts };
  }

  private isUsable(key: string, { step, easing }: Keyframe, before: readonly Keyframe[]): boolean {
    const reject = (given: unknown, accepts: string) => (this.report(placeOf(key), given, accepts), false);
    if (!isWhole(step, 0, MAX_STEP)) return reject(step, OF_STEP);
    if (!isEasing(easing)) return reject(easing, OF_EASING);
    if (before.some((other) => other.step === step)) return reject(step, 'one keyframe at a step');
    if (this.keyframes + before.length === MAX_KEYFRAMES) return reject(step, `at most ${MAX_KEYFRAMES} keyframes`);
    return true;
  }
}

function isWhole(value: unknown, min: number, max: number): boolean {
  return Number.isInteger(value) && (value as number) >= min && (value as number) <= max;
}

function isEasing(easing: unknown): boolean {
  if (!Array.isArray(easing)) return EASINGS.includes(easing);
  const isWithin = (value: unknown, [min, max]: readonly [number, number]) =>
    typeof value === 'number' && value >= min && value <= max;
  return easing.length === 4 && easing.every((value, place) => isWithin(value, place % 2 === 0 ? HANDLE.x : HANDLE.y));
}

function placeOf(key: string): string {
  return `timeline.${key}`;
}

function shortened(given: unknown): string {
  return typeof given === 'object' ? 'an object' : `${given as number | string}`.slice(0, 40);
}
