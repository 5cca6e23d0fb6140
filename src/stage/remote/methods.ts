/**
 * The messages of the methods in `calls.ts`. `portStage.ts` and `protocol.ts` use them, for stages in workers and in frames.
 * Pages import it without a stage, so it imports only types of `src/stage`.
 */
import { requireFinite, requireWhole } from '../../parameters/values.ts';
import type { Vector } from '../../scenes/scene.ts';
import type { EmissionChange, EmissionOptions } from '../../simulator/emitterOptions.ts';
import type { ModelOptions } from '../contract.ts';
import type { Take } from '../take.ts';
import type { calls, MethodName } from './calls.ts';
import {
  blob,
  byteArray,
  figures,
  flag,
  givenValues,
  integer,
  key,
  list,
  nothing,
  nullable,
  number,
  oneOf,
  optional,
  optionsByName,
  record,
  text,
  valuesByKey,
  type Shape,
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
const duration = demanding(number(MAX_SECONDS, 0), (value) => requireFinite({ seconds: value }, 0));
const stepCount = demanding(optional(integer(0, MAX_STEPS)), (value) => requireWhole('n', value));
const state = byteArray(MAX_BYTES);
const vector = list(place, 3) as Shape as Shape<Vector>;
const plane = record({ middle: vector, right: vector, up: vector });

/** A file of at most 64 MB, which the stage checks, or null. */
const modelFile = Object.assign(nullable(state), {
  transferred: (bytes: unknown) => (bytes ? state.transferred!(bytes) : []),
});

const modelNode = record({ name: text, rigid: integer(0, FAR), surface: integer(-1, FAR) });
const model = record({
  triangles: number(FAR),
  materials: number(FAR),
  box: vector,
  nodes: list(modelNode, MAX_KEYS),
  animations: list(record({ name: text, seconds: number(FAR) }), MAX_KEYS),
  notices: list(text, MAX_KEYS),
});

/** A take contains a function, so it is sent as its bytes. */
interface PackedTake extends Omit<Take, 'toBytes'> {
  readonly bytes: Uint8Array<ArrayBuffer>;
}
const recording: Shape<Take> = Object.assign(
  record({
    values: valuesByKey,
    seed: number(2 ** 53),
    inputs: number(FAR),
    start: number(2 ** 53),
    steps: number(2 ** 53),
    mostParticles: number(2 ** 53),
    isFresh: flag,
    isTruncated: flag,
    changed: list(key, MAX_KEYS),
    toBytes: nothing,
    bytes: state,
  }),
  {
    pack: (value: Take) => ({ ...value, toBytes: undefined, bytes: value.toBytes() }),
    unpack: ({ bytes: packed, ...rest }: PackedTake) => ({ ...rest, toBytes: () => packed.slice() }),
    transferred: ({ bytes: packed }: PackedTake) => [packed.buffer],
  },
);

function demanding<Value>(shape: Shape<Value>, demand: (value: unknown) => void): Shape<Value> {
  return Object.assign(shape, { demand });
}

type Shapes<Given extends readonly unknown[]> = { readonly [Place in keyof Given]-?: Shape<Given[Place]> };

/** The messages of a method. The compiler compares the shapes with the parameters and the result of its call. */
export interface MethodEntry<Given extends readonly unknown[] = unknown[], Result = unknown> {
  /** The arguments in a message. */
  readonly takes: Shapes<Given>;
  /** The result in a message. */
  readonly gives: Shape<Result>;
}

type EntryOf<Call> = Call extends (stage: never, ...args: infer Given) => infer Result
  ? MethodEntry<Given, Awaited<Result>>
  : never;

export const methods: { readonly [Name in MethodName]: EntryOf<(typeof calls)[Name]> } = {
  play: { takes: [], gives: nothing },
  pause: { takes: [], gives: nothing },
  step: { takes: [stepCount], gives: nothing },
  seek: { takes: [duration], gives: nothing },
  advance: { takes: [duration], gives: nothing },
  clear: { takes: [], gives: nothing },
  restart: { takes: [], gives: nothing },
  enter: { takes: [givenValues], gives: nothing },
  set: { takes: [givenValues], gives: nothing },
  unset: { takes: [list(key, MAX_KEYS)], gives: nothing },
  get: { takes: [], gives: valuesByKey },
  picture: { takes: [], gives: blob },
  save: { takes: [], gives: state },
  restore: { takes: [state], gives: nothing },
  take: { takes: [], gives: recording },
  readTake: { takes: [state], gives: recording },
  playTake: { takes: [state], gives: nothing },
  hash: { takes: [], gives: text },
  stats: { takes: [optional(record({ gpu: optional(flag) }))], gives: figures },
  resize: { takes: [length, length, optional(number(FAR))], gives: nothing },
  pointer: { takes: [pointer], gives: oneOf('rigid', null) },
  blow: { takes: [blow], gives: nothing },
  steer: { takes: [integer(0, 7), place], gives: nothing },
  emit: { takes: [optionsByName<EmissionOptions>()], gives: integer(0, 2 ** 53) },
  changeEmission: { takes: [integer(0, 2 ** 53), optionsByName<EmissionChange>()], gives: nothing },
  drop: { takes: [place, place], gives: flag },
  setModel: { takes: [modelFile, optional(optionsByName<ModelOptions>())], gives: nullable(model) },
  pickModel: {
    takes: [place, place],
    gives: nullable(record({ node: modelNode, position: vector, direction: vector })),
  },
  nudge: { takes: [record({ dx: optional(place), dy: optional(place), dz: optional(place) })], gives: nothing },
  orbit: { takes: [place, place], gives: nothing },
  zoom: { takes: [number(FAR, 1 / FAR)], gives: nothing },
  pan: { takes: [place, place], gives: nothing },
  resetView: { takes: [], gives: nothing },
  plane: { takes: [], gives: plane },
  setBackground: { takes: [flag], gives: nothing },
  setVisible: { takes: [flag], gives: nothing },
};

export const methodNames = Object.keys(methods) as readonly MethodName[];
