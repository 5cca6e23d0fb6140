import { requireFinite, requireWhole } from '../preset/values.ts';
import type { RemoteMethods } from './contract.ts';
import {
  blob,
  bytes,
  figures,
  flag,
  integer,
  key,
  list,
  nothing,
  number,
  oneOf,
  optional,
  record,
  text,
  values,
  type Check,
} from './shapes.ts';

/** Limits per message, so that one message cannot block the stage indefinitely: ten simulated minutes. */
const MAX_SECONDS = 600;
const MAX_STEPS = 60 * MAX_SECONDS;
const MAX_BYTES = 64 * 1024 * 1024;
/** CSS pixels; the box of an element can be as long as its page. */
const LARGEST_SIDE = 65_536;
/** Greater than any coordinate of a page or a scene. */
const FAR = 1e6;
const MAX_KEYS = 4000;

/** The argument types of a method, by position, and its result type. */
interface Call {
  readonly takes: readonly Check[];
  readonly gives: Check;
  /** The stage's own check of the first argument, so that both report the same error. */
  readonly demand?: (first: unknown) => void;
}

const length = number(LARGEST_SIDE, 0);
const place = number(FAR);
const pointer = record({
  type: oneOf('down', 'move', 'up', 'cancel'),
  id: integer(-(2 ** 31), 2 ** 31),
  x: place,
  y: place,
});
const blow = record({
  x: place,
  y: place,
  dx: optional(place),
  dy: optional(place),
  radius: optional(place),
  seconds: optional(place),
});
const take = record({
  values,
  seed: number(2 ** 53),
  inputs: number(FAR),
  start: number(2 ** 53),
  steps: number(2 ** 53),
  mostParticles: number(2 ** 53),
  isFresh: flag,
  isTruncated: flag,
  toBytes: nothing,
  bytes: bytes(MAX_BYTES),
});

const vector = list(place, 3);
const plane = record({ middle: vector, right: vector, up: vector });

function call(takes: readonly Check[], gives: Check = nothing): Call {
  return { takes, gives };
}

/** Seconds of simulated time. */
const timed: Call = { ...call([number(MAX_SECONDS, 0)]), demand: (seconds) => requireFinite({ seconds }, 0) };

/** The methods that messages can call. No other method is ever called. */
export const calls: Readonly<Record<keyof RemoteMethods, Call>> = {
  play: call([]),
  pause: call([]),
  step: { ...call([optional(integer(0, MAX_STEPS))]), demand: (n = 1) => requireWhole('n', n) },
  seek: timed,
  advance: timed,
  clear: call([]),
  restart: call([]),
  enter: call([values]),
  set: call([values]),
  unset: call([list(key, MAX_KEYS)]),
  get: call([], values),
  picture: call([], blob),
  save: call([], bytes(MAX_BYTES)),
  restore: call([bytes(MAX_BYTES)]),
  take: call([], take),
  readTake: call([bytes(MAX_BYTES)], take),
  playTake: call([bytes(MAX_BYTES)]),
  hash: call([], text),
  stats: call([optional(record({ gpu: optional(flag) }))], figures),
  resize: call([length, length, optional(number(FAR))]),
  pointer: call([pointer], oneOf('rigid', null)),
  blow: call([blow]),
  drop: call([place, place], flag),
  steer: call([integer(0, 7), number(FAR)]),
  nudge: call([record({ dx: optional(place), dy: optional(place), dz: optional(place) })]),
  orbit: call([place, place]),
  zoom: call([number(FAR, 1 / FAR)]),
  pan: call([place, place]),
  resetView: call([]),
  plane: call([], plane),
  setBackground: call([flag]),
  setVisible: call([flag]),
};
