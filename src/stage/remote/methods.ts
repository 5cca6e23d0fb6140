/**
 * The methods of a stage that can be called from another thread or page, in one list. `portStage.ts` and `protocol.ts`
 * make the messages of it, `openHere.ts` the stage of this thread, `src/page/iframe` that of a frame and `src/page/element` the
 * methods of the element. Pages import it without a stage, so it imports only types of `src/stage`.
 */
import { requireFinite, requireWhole } from '../../parameters/values.ts';
import type { GivenValues } from '../../parameters/timeline.ts';
import type { Vector } from '../../scenes/scene.ts';
import type { EmissionChange, EmissionOptions } from '../../simulator/emitterOptions.ts';
import type { BlowInput } from '../gestures.ts';
import type { PointerInput } from '../contract.ts';
import type { Stage } from '../stage.ts';
import type { StatsOptions } from '../stats.ts';
import type { Take } from '../take.ts';
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

/** A method of a stage. The compiler compares the shapes with the parameters and the result of `run`. */
export interface MethodEntry<Given extends readonly unknown[] = unknown[], Result = unknown> {
  /** The arguments in a message. */
  readonly takes: Shapes<Given>;
  /** The result in a message. */
  readonly gives: Shape<Result>;
  /** Calls the stage. Its other parameters and its result are those of the method. */
  run(stage: Stage, ...args: Given): Result | Promise<Result>;
}

function method<Given extends readonly unknown[], Result>(entry: {
  takes: Shapes<NoInfer<Given>>;
  gives: Shape<NoInfer<Result>>;
  run: MethodEntry<Given, Result>['run'];
}): MethodEntry<Given, Result> {
  return entry;
}

/** A loading error was already reported; the call works without the missing code. */
function completed(stage: Stage): Promise<void> {
  return stage.complete().catch(() => undefined);
}

export const methods = {
  play: method({ takes: [], gives: nothing, run: (stage) => stage.play() }),
  pause: method({ takes: [], gives: nothing, run: (stage) => stage.pause() }),
  /** @param n an integer of at least 0. Default: 1. At most 36,000 in a worker or an iframe */
  step: method({
    takes: [stepCount],
    gives: nothing,
    run: async (stage, n?: number) => {
      await completed(stage);
      stage.step(n);
    },
  }),
  /** @param seconds simulated time, at least 0; at most 600 in a worker or an iframe */
  seek: method({ takes: [duration], gives: nothing, run: (stage, seconds: number) => stage.seek(seconds) }),
  /** @param seconds simulated time, at least 0; at most 600 in a worker or an iframe */
  advance: method({
    takes: [duration],
    gives: nothing,
    run: async (stage, seconds: number) => {
      await completed(stage);
      stage.advance(seconds);
    },
  }),
  /** Removes all puffs; emitters and values stay. */
  clear: method({ takes: [], gives: nothing, run: (stage) => stage.clear() }),
  restart: method({ takes: [], gives: nothing, run: (stage) => stage.restart() }),
  /** Loads another scene, or restarts the current one. Omitted values get their defaults. */
  enter: method({ takes: [givenValues], gives: nothing, run: (stage, values: GivenValues) => stage.enter(values) }),
  /** Rejects also if the timeline is invalid; it resolves when its code is loaded. */
  set: method({
    takes: [givenValues],
    gives: nothing,
    run: (stage, values: GivenValues) => stage.setChecked(values),
  }),
  unset: method({
    takes: [list(key, MAX_KEYS)],
    gives: nothing,
    run: (stage, keys: readonly string[]) => stage.unset(keys),
  }),
  get: method({ takes: [], gives: valuesByKey, run: (stage) => stage.get() }),
  /** A PNG at full resolution, also while the canvas is not visible. */
  picture: method({ takes: [], gives: blob, run: (stage) => stage.picture() }),
  save: method({ takes: [], gives: state, run: (stage) => stage.save() }),
  restore: method({ takes: [state], gives: nothing, run: (stage, bytes: Uint8Array) => stage.restore(bytes) }),
  take: method({ takes: [], gives: recording, run: (stage) => stage.take() }),
  /** Reads the metadata of a take without playing it. */
  readTake: method({ takes: [state], gives: recording, run: (stage, bytes: Uint8Array) => stage.readTake(bytes) }),
  /** @param take the result of `take()`, or its bytes */
  playTake: method({
    takes: [state],
    gives: nothing,
    run: (stage, take: Take | Uint8Array) => stage.playTake(take),
  }),
  /** 16 hexadecimal digits. */
  hash: method({ takes: [], gives: text, run: (stage) => stage.hash() }),
  stats: method({
    takes: [optional(record({ gpu: optional(flag) }))],
    gives: figures,
    run: (stage, options?: StatsOptions) => {
      stage.timeGpu(options?.gpu ?? false);
      return stage.stats;
    },
  }),
  /** @param width, height in CSS pixels, at most 65,536 */
  resize: method({
    takes: [length, length, optional(number(FAR))],
    gives: nothing,
    run: (stage, width: number, height: number, pixelRatio?: number) => stage.resize(width, height, pixelRatio),
  }),
  pointer: method({
    takes: [pointer],
    gives: oneOf('rigid', null),
    run: (stage, input: PointerInput) => stage.pointer(input),
  }),
  blow: method({ takes: [blow], gives: nothing, run: (stage, input: BlowInput) => stage.blow(input) }),
  steer: method({
    takes: [integer(0, 7), place],
    gives: nothing,
    run: (stage, channel: number, value: number) => stage.steer(channel, value),
  }),
  /** Resolves to the number of the emission. */
  emit: method({
    takes: [optionsByName<EmissionOptions>()],
    gives: integer(0, 2 ** 53),
    run: (stage, given: EmissionOptions) => stage.emit(given),
  }),
  /** @param emission the result of `emit` */
  changeEmission: method({
    takes: [integer(0, 2 ** 53), optionsByName<EmissionChange>()],
    gives: nothing,
    run: (stage, emission: number, given: EmissionChange) => stage.changeEmission(emission, given),
  }),
  /**
   * Drops a ball or a crate at a position in the picture, in CSS pixels. Resolves to false if the scene has no objects
   * to drop.
   */
  drop: method({ takes: [place, place], gives: flag, run: (stage, x: number, y: number) => stage.drop(x, y) }),
  /** Moves the target of the movable rigid, in metres. */
  nudge: method({
    takes: [record({ dx: optional(place), dy: optional(place), dz: optional(place) })],
    gives: nothing,
    run: (stage, by: { dx?: number; dy?: number; dz?: number }) => stage.nudge(by),
  }),
  /** Rotates the camera about its target, in radians. */
  orbit: method({
    takes: [place, place],
    gives: nothing,
    run: (stage, azimuth: number, elevation: number) => stage.camera.orbit(azimuth, elevation),
  }),
  /** A factor above 1 moves the camera closer. */
  zoom: method({
    takes: [number(FAR, 1 / FAR)],
    gives: nothing,
    run: (stage, factor: number) => stage.camera.zoom(factor),
  }),
  /** @param x, y in CSS pixels */
  pan: method({ takes: [place, place], gives: nothing, run: (stage, x: number, y: number) => stage.camera.pan(x, y) }),
  resetView: method({ takes: [], gives: nothing, run: (stage) => stage.camera.reset() }),
  /** The plane that maps picture positions to the scene, for page elements that the smoke collides with. */
  plane: method({ takes: [], gives: plane, run: (stage) => stage.sight.plane }),
  /** Whether to draw the background; without it, pictures are transparent there. */
  setBackground: method({
    takes: [flag],
    gives: nothing,
    run: (stage, isShown: boolean) => {
      stage.background = isShown;
    },
  }),
  /** Whether the canvas is visible. While it is not, nothing is drawn. A paused stage stays paused. */
  setVisible: method({
    takes: [flag],
    gives: nothing,
    run: (stage, isVisible: boolean) => {
      stage.visible = isVisible;
    },
  }),
};

export type MethodName = keyof typeof methods;

export const methodNames = Object.keys(methods) as readonly MethodName[];

/** A method as its callers see it. */
export type RemoteMethod<Run> = Run extends (stage: never, ...args: infer Given) => infer Result
  ? (...args: Given) => Promise<Awaited<Result>>
  : never;

/**
 * The asynchronous methods of a remote stage, named as in `Stage`. Each rejects with the error that `Stage` would
 * throw, as the same class, and with a SimulatorError after disposal. A stage in a worker or an iframe rejects values
 * outside the ranges given here with a ParameterError.
 */
export type RemoteMethods = { [Name in MethodName]: RemoteMethod<(typeof methods)[Name]['run']> };

/** Makes methods of these names from one function that calls any of them. */
export function makeMethods<Name extends MethodName>(
  names: readonly Name[],
  call: (name: Name, args: unknown[]) => Promise<unknown>,
): Pick<RemoteMethods, Name> {
  const made = names.map((name) => [name, (...args: unknown[]) => call(name, args)]);
  return Object.fromEntries(made) as Pick<RemoteMethods, Name>;
}
