import { ParameterError, requireOptions } from '../base/errors.ts';
import { endsOf, LIST_LIMIT, lists, LOOK_STYLE } from '../parameters/lists.ts';
import { accepted, type Parameter, type AnyValues, type Value } from '../parameters/parameter.ts';
import { findParameter, table } from '../parameters/table.ts';
import { isAccepted } from '../parameters/values.ts';
import { STEP_SECONDS } from './clock.ts';
import { NO_STYLE, numberOfStyle, type LookStyle } from './lookStyles.ts';
import { simulatorValues } from './simulatorValues.ts';

/** VectorComponents of a vector, for example of a Vector3 of three.js. */
export interface VectorComponents {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** What distinguishes the puffs of an emitter from other smoke. What is not set follows the smoke. */
export interface EmitterLook extends Partial<LookStyle> {
  /** Lifetime in seconds, 0 to 600. Puffs grow within a quarter of it. 0 follows the smoke. */
  lifetime?: number;
  /** Seconds in which puffs reach their size, 0 to 20. 0 follows the smoke. */
  growthTime?: number;
  /** Fraction of its size that a puff has over its life, as stops `0:1,.5:.8,1:0`. */
  sizeCurve?: string;
  /** Density over its life, as `emission.density`. */
  densityCurve?: string;
  /** How puffs end, as `emission.dissolve`; `smoke` follows the smoke. */
  dissolve?: 'smoke' | 'shrink' | 'erode' | 'tear' | 'thin';
  /** Factors on drag, buoyancy and gravity, 0 to 10. */
  drag?: number;
  buoyancy?: number;
  gravity?: number;
}

/** How an emitter emits. Lengths are in metres; see `emitters.#` in the parameter table for each value and its range. */
export interface PuffOptions {
  /** Shape of the source. Default `disc` for an object, `ball` for a burst. */
  shape?: 'point' | 'disc' | 'ball' | 'ring' | 'sphere' | 'box' | 'cone' | 'line';
  /** Radius of the shape, 0 to 100. Default 0.1. */
  radius?: number;
  /** Inner radius of a ring, as a fraction of its radius, 0 to 1. Default 0.8. */
  inner?: number;
  /** Half sides of a box, or half of a line. Default 0.5 each. */
  extent?: VectorComponents;
  /** Speed at which puffs leave, m/s, 0 to 50. Default 0.5. */
  speed?: number;
  /** Largest random change of the speed, as a fraction, 0 to 1. Default 0.2. */
  speedVariation?: number;
  /** Half angle of the cone in which puffs leave, radians, 0 to pi. Default 0.3. */
  spread?: number;
  /** Radius of puffs, 0.001 to 20. Default 0.3. */
  size?: number;
  /** Largest random change of the size, as a fraction, 0 to 1. Default 0.2. */
  sizeVariation?: number;
  /** Lifetime relative to `emission.lifetime`, 0.05 to 20. Default 1. */
  lifetime?: number;
  /** Largest random change of the lifetime, as a fraction, 0 to 1. Default 0.2. */
  lifetimeVariation?: number;
  /** Temperature of new puffs, 0 to 4. Warm smoke rises. Default 1. */
  temperature?: number;
  /** Number of the tint, 1 to 15; 0 is none (default). There are three colours, which repeat. */
  tint?: number;
  /** The look of its puffs, at most 15 different ones at a time. An object replaces the one before. Default: that of the smoke. */
  look?: EmitterLook;
}

/** Options of an emitter that follows an object. */
export interface EmitterOptions extends PuffOptions {
  /** Puffs per second, 0 to 1000. Default 30. */
  rate?: number;
  /** Puffs per metre that the object travels, besides the rate, 0 to 1000. Default 0. */
  perMetre?: number;
  /** Fraction of the velocity of the object that puffs inherit, 0 to 1. Default 0. */
  inherit?: number;
}

/** Options of a burst. */
export interface BurstOptions extends PuffOptions {
  /** Centre in world space. */
  position: VectorComponents;
  /** Number of puffs, 1 to 20,000. */
  count: number;
  /** Direction in which puffs leave, of any length. Default: all directions. */
  direction?: VectorComponents;
}

/** Options of an emission. Without `duration`, `count` puffs appear at once, or `rate` goes on until a change ends it. */
export interface EmissionOptions extends PuffOptions {
  /** Centre, in the space of the scene. */
  position: VectorComponents;
  /** Direction in which puffs leave, of any length. Default: all directions. */
  direction?: VectorComponents;
  /** Number of puffs, 1 to 20,000. Either this or `rate` is required. */
  count?: number;
  /** Puffs per second, 0 to 1000. */
  rate?: number;
  /** Puffs per metre that its position travels, besides the others, 0 to 1000. Default 0. */
  perMetre?: number;
  /** Seconds from the start to the end, rounded to steps of 1/60 s, of which there is at least one; up to 3600. */
  duration?: number;
  /** Simulated seconds from the next step to the start, rounded to steps, 0 to 3600. Default 0. */
  delay?: number;
}

/** What can change while puffs are emitted. `duration` still counts from the start: 0 ends an emission. */
export type EmissionChange = Partial<Omit<EmissionOptions, 'count' | 'delay'>>;

/** An option of a call: the first number that it sets, and the parameter of the table. */
interface Field {
  readonly index: number;
  readonly parameter: Parameter;
  /** Whether it sets three numbers. */
  readonly isVector: boolean;
}

const PREFIX = 'emitters.0.';
/** Parameters of an emitter. */
const PARAMETERS = table.filter(({ key }) => key.startsWith(PREFIX));
/** Keys of the numbers of an emitter in the order in which the simulator takes them, `EMITTER_NUMBERS` in Rust. */
const NUMBERS = lists.emitters.flatMap((field) => endsOf(field).map((end) => field.key + end));
/** The mesh surfaces that the shape `surface` needs are not part of this API. */
function withoutSurface(parameter: Parameter): Parameter {
  if (parameter.kind !== 'choice') return parameter;
  return { ...parameter, options: parameter.options.filter(({ value }) => value !== 'surface') };
}
const PUFF_KEYS =
  'shape radius inner extent speed speedVariation spread size sizeVariation lifetime lifetimeVariation temperature tint'.split(
    ' ',
  );
export const AXES = ['x', 'y', 'z'] as const;
const MAX_COUNT = 20_000;
/** Puffs per second, `MAX_RATE` in Rust. */
const MAX_RATE = 20_000;
/** Emissions that are not over, at a time: `POOL_LIMIT` in Rust. */
export const EMISSION_LIMIT = 384;
const ALL_DIRECTIONS = Math.PI;

/** Index of a number of an emitter. */
function indexOf(key: string): number {
  return NUMBERS.indexOf(key);
}

export const RIGID = indexOf('rigid');
const SHARE = indexOf('share');
const SPREAD = indexOf('spread');
const DIRECTION = indexOf('direction.x');
const BURST = indexOf('burst.count');
const DURATION = indexOf('envelope.duration');
const DELAY = indexOf('envelope.start');

/** The share of an emitter outside the table is its rate. */
const INDICES: Readonly<Record<string, number>> = { rate: SHARE, duration: DURATION, delay: DELAY };

function fieldsOf(keys: readonly string[]): ReadonlyMap<string, Field> {
  return new Map(
    keys.map((key) => {
      const isVector = indexOf(key) < 0 && INDICES[key] === undefined;
      const index = INDICES[key] ?? indexOf(isVector ? `${key}.x` : key);
      return [key, { index, parameter: withoutSurface(findParameter(PREFIX + NUMBERS[index])!), isVector }];
    }),
  );
}

const OBJECT_FIELDS = fieldsOf([...PUFF_KEYS, 'inherit', 'rate', 'perMetre']);
const BURST_FIELDS = fieldsOf([...PUFF_KEYS, 'position', 'direction']);
const CHANGE_FIELDS = fieldsOf([...PUFF_KEYS, 'position', 'direction', 'rate', 'perMetre', 'duration']);
const EMISSION_FIELDS = new Map([...CHANGE_FIELDS, ...fieldsOf(['delay'])]);

/** The numbers of an emitter with these values of emitter 0 of the table. */
function numbersOf(values: AnyValues): Float64Array {
  const given = Object.fromEntries(PARAMETERS.map(({ key, default: initial }) => [key, values[key] ?? initial]));
  const numbers = simulatorValues(given);
  return Float64Array.from(NUMBERS, (key) => numbers[PREFIX + key]);
}

const OBJECT_NUMBERS = numbersOf({ 'emitters.0.shape': 'disc', 'emitters.0.share': 30 });
const BURST_NUMBERS = numbersOf({ 'emitters.0.shape': 'ball', 'emitters.0.share': 0 });

/**
 * Numbers of an emitter for the simulator.
 * @param before numbers that options change; the defaults if omitted
 * @throws ParameterError for an unknown option or an invalid value
 */
export function emitterNumbers(call: string, options: EmitterOptions, before = OBJECT_NUMBERS): Float64Array {
  const numbers = before.slice();
  write(call, options, OBJECT_FIELDS, numbers);
  return numbers;
}

/** Numbers that options have not set. */
export const NOT_SET: Float64Array = Float64Array.from(NUMBERS, () => NaN);

/**
 * Numbers of an emitter that follows an object with the values of emitter 0 of the table.
 * @param parameters those of the simulator by key, which has the shares of all emitters of the table
 */
export function followerNumbers(values: AnyValues, parameters: ReadonlyMap<string, number>): Float64Array {
  const numbers = numbersOf(values);
  numbers.set([0, 0, 0], indexOf('position.x'));
  numbers.set([0, 1, 0], DIRECTION);
  let shares = 0;
  for (let emitter = 0; emitter < LIST_LIMIT; emitter++) shares += parameters.get(`emitters.${emitter}.share`) ?? 0;
  numbers[SHARE] = shares > 0 ? (parameters.get('emission.rate')! * numbers[SHARE]) / shares : 0;
  return numbers;
}

const burst = BURST_NUMBERS.slice();

/**
 * Numbers of the emitter of a burst, in an array that the next call overwrites.
 * @throws ParameterError for an unknown option or an invalid value
 */
export function burstNumbers(options: BurstOptions): Float64Array {
  burst.set(BURST_NUMBERS);
  writePlaced('burst', options, BURST_FIELDS, burst);
  requireCount('burst', options.count);
  return burst;
}

/**
 * Numbers of an emission.
 * @throws ParameterError for an unknown option or an invalid value
 */
export function emissionNumbers(options: EmissionOptions): Float64Array {
  const numbers = BURST_NUMBERS.slice();
  writePlaced('emit', options, EMISSION_FIELDS, numbers);
  const { count, rate, duration } = options;
  numbers[DELAY] = wholeSteps(numbers[DELAY]);
  if (count === undefined && rate !== undefined) return lasting(numbers, duration);
  if (rate !== undefined) throw new ParameterError('emit.rate', rate, 'no value together with count');
  requireCount('emit', count!);
  lasting(numbers, duration ?? 0);
  if (duration === undefined) numbers[BURST] = count!;
  else numbers[SHARE] = count! / numbers[DURATION];
  if (numbers[SHARE] > MAX_RATE)
    throw new ParameterError('emit.duration', duration, `at least ${count! / MAX_RATE} s for ${count} puffs`);
  return numbers;
}

/**
 * Numbers of a change of an emission; NaN where it changes nothing.
 * @throws ParameterError for an unknown option or an invalid value
 */
export function changeNumbers(options: EmissionChange): Float64Array {
  const numbers = NOT_SET.slice();
  write('changeEmission', options, CHANGE_FIELDS, numbers);
  return lasting(numbers, options.duration);
}

function lasting(numbers: Float64Array, duration: number | undefined): Float64Array {
  if (duration !== undefined) numbers[DURATION] = Math.max(wholeSteps(duration), STEP_SECONDS);
  return numbers;
}

function wholeSteps(seconds: number): number {
  return Math.round(seconds / STEP_SECONDS) * STEP_SECONDS;
}

function writePlaced(
  call: string,
  options: BurstOptions | EmissionOptions,
  fields: ReadonlyMap<string, Field>,
  numbers: Float64Array,
): void {
  write(call, options, fields, numbers, 'count');
  if (options.position === undefined)
    throw new ParameterError(`${call}.position`, undefined, 'a vector x, y, z in metres');
  if (options.direction === undefined && options.spread === undefined) numbers[SPREAD] = ALL_DIRECTIONS;
}

/** @throws ParameterError unless `count` is a number of puffs */
export function requireCount(call: string, count: number): void {
  if (Number.isInteger(count) && count >= 1 && count <= MAX_COUNT) return;
  throw new ParameterError(`${call}.count`, count, `a whole number from 1 to ${MAX_COUNT}`);
}

/** Values of the parameter table that options of an emitter of the table stand for. */
export function tableValues(call: string, emitter: number, options: EmitterOptions): Record<string, number | string> {
  if (options?.rate !== undefined)
    throw new ParameterError(`${call}.rate`, options.rate, `no value: set emitters.${emitter}.share and emission.rate`);
  emitterNumbers(call, options);
  const values: Record<string, number | string> = {};
  for (const [key, value] of Object.entries(options)) {
    const name = `emitters.${emitter}.${key}`;
    if (key === 'look') Object.assign(values, lookValues(value as EmitterLook, `emitters.${emitter}.`));
    else if (typeof value === 'object')
      for (const axis of AXES) values[`${name}.${axis}`] = (value as VectorComponents)[axis];
    else if (value !== undefined) values[name] = value as number | string;
  }
  return values;
}

// Bursts come often: this creates no objects.
function write(
  call: string,
  options: EmitterOptions | BurstOptions | EmissionChange,
  fields: ReadonlyMap<string, Field>,
  numbers: Float64Array,
  besides?: string,
): void {
  if (typeof options !== 'object' || options === null) throw new ParameterError(call, options, 'an object of options');
  for (const key in options) {
    const value: unknown = options[key as never];
    if (value === undefined || key === besides) continue;
    if (key === 'look') {
      writeLook(`${call}.look`, value as EmitterLook, numbers);
      continue;
    }
    const field = fields.get(key);
    if (!field) throw unknownOption(call, key, value, fields, besides);
    if (field.isVector) writeVector(call, key, value as VectorComponents, field, numbers);
    else numbers[field.index] = checked(call, key, value, field.parameter);
  }
}

const LOOK = 'look.';
/** Names of the options of a look. */
const LOOK_NAMES = PARAMETERS.flatMap(({ key }) =>
  key.startsWith(PREFIX + LOOK) ? [key.slice((PREFIX + LOOK).length)] : [],
);

/** All values of a look under an emitter of the table. What is not set follows the smoke. */
function lookValues(look: EmitterLook, prefix: string): Record<string, Value> {
  return Object.fromEntries(
    LOOK_NAMES.map((name) => {
      const { default: initial } = findParameter(PREFIX + LOOK + name)!;
      return [prefix + LOOK + name, (look as AnyValues)[name] ?? initial];
    }),
  );
}

function writeLook(call: string, look: EmitterLook, numbers: Float64Array): void {
  requireOptions(call, look, LOOK_NAMES);
  const values = lookValues(look, PREFIX);
  for (const [key, value] of Object.entries(values)) {
    const parameter = findParameter(key)!;
    if (!isAccepted(parameter, value))
      throw new ParameterError(`${call}.${key.slice((PREFIX + LOOK).length)}`, value, accepted(parameter));
  }
  const found = simulatorValues(values);
  const style = Object.fromEntries(
    Object.entries(NO_STYLE).map(([name, initial]) => [name, look[name as keyof LookStyle] ?? initial]),
  );
  // Those of the table have other numbers.
  if (found[PREFIX + LOOK_STYLE] > 0) found[PREFIX + LOOK_STYLE] = numberOfStyle(style as unknown as LookStyle);
  for (const key in found) numbers[indexOf(key.slice(PREFIX.length))] = found[key];
}

function writeVector(
  call: string,
  key: string,
  vector: VectorComponents,
  { index, parameter }: Field,
  numbers: Float64Array,
): void {
  if (typeof vector !== 'object' || vector === null)
    throw new ParameterError(`${call}.${key}`, vector, 'a vector x, y, z');
  const scale = index === DIRECTION ? scaleOfDirection(call, key, vector) : 1;
  for (let axis = 0; axis < 3; axis++) {
    const value = vector[AXES[axis]] * scale;
    if (!isAccepted(parameter, value))
      throw new ParameterError(`${call}.${key}.${AXES[axis]}`, value, accepted(parameter));
    numbers[index + axis] = value;
  }
}

/** The factor that makes the largest component of a direction 1. */
function scaleOfDirection(call: string, key: string, { x, y, z }: VectorComponents): number {
  const most = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
  if (most > 0 && most < Infinity) return 1 / most;
  throw new ParameterError(`${call}.${key}`, `${x}, ${y}, ${z}`, 'a finite vector other than 0');
}

function checked(call: string, key: string, value: unknown, parameter: Parameter): number {
  if (!isAccepted(parameter, value)) throw new ParameterError(`${call}.${key}`, value, accepted(parameter));
  return numberOf(parameter, value as number | string);
}

function numberOf(parameter: Parameter, value: number | string): number {
  if (parameter.kind !== 'choice') return value as number;
  for (let index = 0; index < parameter.options.length; index++)
    if (parameter.options[index].value === value) return index;
  return -1;
}

function unknownOption(
  call: string,
  key: string,
  value: unknown,
  fields: ReadonlyMap<string, Field>,
  besides: string | undefined,
): ParameterError {
  const known = [...fields.keys(), 'look', ...(besides ? [besides] : [])];
  return new ParameterError(`${call}.${key}`, value, `no value: its options are ${known.join(', ')}`);
}
