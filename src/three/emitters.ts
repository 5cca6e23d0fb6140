import { Vector3, type Object3D, type Vector3Like } from 'three';
import { ParameterError } from '../base/errors.ts';
import { LIST_LIMIT } from '../parameters/lists.ts';
import type { Values } from '../parameters/parameter.ts';
import {
  AXES,
  burstNumbers,
  emitterNumbers,
  followerNumbers,
  NOT_SET,
  requireCount,
  RIGID,
  tableValues,
  type BurstOptions,
  type EmitterOptions,
} from '../simulator/emitterOptions.ts';
import type { Simulator } from '../simulator/simulator.ts';
import { namingLook } from '../simulator/simulatorError.ts';
import { Handle, type Handles, type SmokeHandle } from './handle.ts';
import type { Overrides } from './overrides.ts';
import type { SmokeFrame } from './smokeSpace.ts';
import { worldPose, type ObjectPart, type ObjectParts } from './objectParts.ts';
import { newPose } from './shapes.ts';

/** What `emitFrom` returns. */
export interface EmitterHandle extends SmokeHandle {
  /**
   * Changes options; the others stay. An emitter of the table takes no `rate`.
   * @throws ParameterError for an unknown option or an invalid value; nothing changes then
   */
  set(values: EmitterOptions): void;
  /**
   * Emits puffs at once in the next step, besides its rate; nothing while it is paused.
   * @param count whole number from 1 to 20,000
   * @returns resolves in the step in which the last of these puffs ends by its lifetime, also if it was removed before; when
   * all puffs are cleared; and when the handle pauses before they are emitted
   */
  burst(count: number): Promise<void>;
}

/** Emitters of the simulator's pool, which follow those of the table: those of objects come first, then bursts in turn. */
const OBJECT_SLOTS = 128;
const BURST_SLOTS = 256;
const NO_NUMBERS = new Float64Array();

/** A burst whose promise has not resolved. */
interface Burst {
  readonly emitter: number;
  /** Number of steps at which its last puff ends; -1 while births wait. */
  end: number;
  resolve(): void;
}

/** The emitters of one smoke outside the parameter table. */
export class EmitterPool {
  readonly simulator: Simulator;
  readonly parts: ObjectParts;
  /** Indices of the emitters of active handles. */
  readonly used = new Set<number>();
  /** Those of active handles that follow the table. */
  readonly followers = new Set<PooledEmitter>();
  private readonly isTaken: boolean[] = Array.from({ length: OBJECT_SLOTS }, () => false);
  private bursts = 0;
  private unfinished: Burst[] = [];

  constructor(simulator: Simulator, parts: ObjectParts) {
    this.simulator = simulator;
    this.parts = parts;
  }

  /** Index of a free emitter for the simulator. @throws ParameterError when all are taken */
  acquire(): number {
    const slot = this.isTaken.indexOf(false);
    if (slot < 0) throw new ParameterError('emitFrom', OBJECT_SLOTS + 1, `at most ${OBJECT_SLOTS} objects at a time`);
    this.isTaken[slot] = true;
    return LIST_LIMIT + slot;
  }

  release(index: number): void {
    this.isTaken[index - LIST_LIMIT] = false;
  }

  /** After the simulator took another state: frees the emitters that no handle uses. */
  freeOthers(): void {
    for (let index = LIST_LIMIT; index < LIST_LIMIT + OBJECT_SLOTS; index++)
      if (!this.used.has(index)) this.simulator.setEmitter(index, NO_NUMBERS);
  }

  /** Emits puffs in the next step. The oldest of the bursts that still wait gives way if there are too many. */
  burst(options: BurstOptions): Promise<void> {
    const numbers = burstNumbers(placedIn(options, this.parts.frame));
    const index = LIST_LIMIT + OBJECT_SLOTS + (this.bursts % BURST_SLOTS);
    namingLook('burst', () => this.simulator.setEmitter(index, numbers, options.count));
    if (this.bursts++ >= BURST_SLOTS) this.resolveUnborn(index);
    return this.endOf(index);
  }

  /** Resolves when the puffs end that an emitter emits at once in the next step. */
  endOf(emitter: number): Promise<void> {
    return new Promise((resolve) => this.unfinished.push({ emitter, end: -1, resolve }));
  }

  /** Resolves the promises of bursts whose puffs have ended. Call it after each step. */
  settle(): void {
    if (this.unfinished.length === 0) return;
    const { steps } = this.simulator;
    for (const burst of this.unfinished) if (burst.end < 0) burst.end = this.simulator.burstEnd(burst.emitter);
    this.resolve(({ end }) => end >= 0 && end <= steps);
  }

  /** Resolves the promises of bursts, such as those of an emitter without its births that wait. */
  resolve(isOver: (burst: Pick<Burst, 'emitter' | 'end'>) => boolean): void {
    const over = this.unfinished.filter(isOver);
    this.unfinished = this.unfinished.filter((burst) => !over.includes(burst));
    for (const burst of over) burst.resolve();
  }

  /** Drops the births of an emitter that wait. */
  drop(index: number): void {
    this.simulator.setEmitter(index, NO_NUMBERS);
    this.resolveUnborn(index);
  }

  private resolveUnborn(index: number): void {
    this.resolve(({ emitter, end }) => emitter === index && end < 0);
  }
}

/** An emitter of the pool that follows an object. */
export class PooledEmitter extends Handle implements EmitterHandle {
  private readonly pool: EmitterPool;
  private readonly index: number;
  private readonly table: TableNumbers | undefined;
  /** The numbers that options have set; NaN for those of the table. */
  private own: Float64Array;
  /** The numbers of the table that it has. */
  private base: Float64Array | undefined;
  private part: ObjectPart | undefined;

  /** @param options or the table, whose emitter 0 it follows */
  constructor(pool: EmitterPool, object: Object3D, options: EmitterOptions | TableNumbers) {
    super('emitFrom', object);
    this.table = options instanceof TableNumbers ? options : undefined;
    this.own = options instanceof TableNumbers ? NOT_SET : emitterNumbers('emitFrom', options);
    this.requireSound(pool.parts.frame.toSmoke(worldPose(object, pose)));
    this.pool = pool;
    this.index = pool.acquire();
  }

  set(values: EmitterOptions): void {
    this.requireUsable('set');
    const before = this.own;
    this.own = emitterNumbers('emitFrom', values, before);
    try {
      if (this.part) this.write();
    } catch (error) {
      this.own = before;
      throw error;
    }
  }

  burst(count: number): Promise<void> {
    this.requireUsable('burst');
    requireCount('emitFrom.burst', count);
    if (!this.isActive) return Promise.resolve();
    this.pool.simulator.setEmitter(this.index, NO_NUMBERS, count);
    return this.pool.endOf(this.index);
  }

  override join(handles: Handles): void {
    try {
      super.join(handles);
    } catch (error) {
      this.release();
      throw error;
    }
  }

  protected start(): void {
    const { parts } = this.pool;
    this.requireSound(parts.frame.toSmoke(worldPose(this.object, pose)));
    this.part = parts.add(pose);
    try {
      this.write();
    } catch (error) {
      this.stop();
      throw error;
    }
    this.table?.overrides.reserve('emitters.0');
    if (this.table) this.pool.followers.add(this);
  }

  /** Takes over values of the table that have changed. */
  followTable(): void {
    if (this.table!.read() !== this.base) this.write();
  }

  protected override follow(): void {
    const { parts } = this.pool;
    this.requireSound(parts.frame.toSmoke(worldPose(this.object, pose)));
    parts.move(this.part!, pose);
    if (this.table) this.followTable();
  }

  protected stop(): void {
    this.pool.parts.remove(this.part!);
    this.part = undefined;
    this.pool.used.delete(this.index);
    this.pool.followers.delete(this);
    this.pool.drop(this.index);
  }

  protected override release(): void {
    this.pool.release(this.index);
  }

  private write(): void {
    const base = (this.base = this.table?.read() ?? this.own);
    const numbers = this.own.map((number, index) => (Number.isNaN(number) ? base[index] : number));
    numbers[RIGID] = this.part!.number;
    namingLook('emitFrom', () => this.pool.simulator.setEmitter(this.index, numbers));
    this.pool.used.add(this.index);
  }
}

/** Emitter 0 of the parameter table as numbers of an emitter of the pool. */
export class TableNumbers {
  readonly overrides: Overrides;
  private readonly simulator: Simulator;
  private readonly values: () => Values;
  private seen: Values | undefined;
  private numbers: Float64Array = NO_NUMBERS;

  /** @param values the current ones, another object after each change */
  constructor(simulator: Simulator, overrides: Overrides, values: () => Values) {
    this.simulator = simulator;
    this.overrides = overrides;
    this.values = values;
  }

  /** Another array after each change of values. */
  read(): Float64Array {
    const values = this.values();
    if (values !== this.seen) this.numbers = followerNumbers(values, this.simulator.parameters());
    this.seen = values;
    return this.numbers;
  }
}

/** What an emitter of the table needs of its smoke. */
export interface TableContext {
  readonly simulator: Simulator;
  readonly overrides: Overrides;
  readonly frame: SmokeFrame;
  readonly emitters: EmitterPool;
  /** Takes an item of the table from what carries it. */
  release(item: string): void;
  /** Changes values of the parameter table. */
  set(values: Values): void;
}

/** An emitter of the parameter table that follows an object. It is silent while none of its handles is active. */
export class TableEmitter extends Handle implements EmitterHandle {
  private readonly context: TableContext;
  private readonly emitter: number;
  private readonly direction = new Vector3();

  /** @param emitter index from 0 to 7 */
  constructor(context: TableContext, object: Object3D, emitter: number) {
    super('emitFrom', object);
    requireEmitter(emitter);
    this.context = context;
    this.emitter = emitter;
  }

  set(values: EmitterOptions): void {
    this.requireUsable('set');
    namingLook('emitFrom', () => this.context.set(tableValues('emitFrom', this.emitter, values)));
  }

  burst(count: number): Promise<void> {
    this.requireUsable('burst');
    requireCount('emitFrom.burst', count);
    if (!this.isActive) return Promise.resolve();
    this.write();
    this.context.simulator.setEmitter(this.emitter, NO_NUMBERS, count);
    return this.context.emitters.endOf(this.emitter);
  }

  override move(): void {
    if (this.isActive) this.write();
  }

  protected start(): void {
    this.follow();
    this.context.overrides.reserve(`emitters.${this.emitter}`);
    this.context.release(`emitters.${this.emitter}`);
    this.context.overrides.unmute(`emitters.${this.emitter}`);
  }

  protected override follow(): void {
    this.requireSound(this.context.frame.toSmoke(worldPose(this.object, pose)));
  }

  protected stop(): void {
    this.context.overrides.mute(`emitters.${this.emitter}`);
  }

  /** Gives the emitter the place that its values describe. */
  protected override release(): void {
    for (const vector of ['position', 'direction'])
      for (const axis of AXES) {
        const key = `emitters.${this.emitter}.${vector}.${axis}`;
        this.context.overrides.put(key, 0);
        this.context.overrides.drop(key);
      }
  }

  private write(): void {
    const { object, emitter, direction } = this;
    const { frame } = this.context;
    const { position } = frame.toSmoke(worldPose(object, pose));
    direction.set(0, 1, 0).transformDirection(object.matrixWorld);
    if (frame.isMoved) frame.rotate(direction);
    const key = `emitters.${emitter}`;
    this.context.simulator.set({
      ...vectorValues(`${key}.position`, position),
      ...vectorValues(`${key}.direction`, direction),
    });
  }
}

const pose = newPose();

/** The options in the space of the smoke. Invalid ones stay as they are. */
function placedIn(options: BurstOptions, frame: SmokeFrame): BurstOptions {
  if (!frame.isMoved || !isObject(options)) return options;
  const { position, direction } = options;
  const moved = { ...options };
  if (isObject(position)) moved.position = frame.toSmoke({ ...newPose(), position: copyOf(position) }).position;
  if (isObject(direction)) moved.direction = frame.rotate(copyOf(direction));
  return moved;
}

function isObject(given: unknown): given is object {
  return typeof given === 'object' && given !== null;
}

/** A missing component stays missing, which is an error, instead of 0. */
function copyOf({ x, y, z }: Vector3Like): Vector3 {
  return Object.assign(new Vector3(), { x, y, z });
}

/** @throws ParameterError when there is no emitter with this index */
function requireEmitter(emitter: number): void {
  if (Number.isInteger(emitter) && emitter >= 0 && emitter < LIST_LIMIT) return;
  throw new ParameterError('emitter', emitter, `a whole number from 0 to ${LIST_LIMIT - 1}`);
}

function vectorValues(key: string, { x, y, z }: Vector3): Record<string, number> {
  return { [`${key}.x`]: x, [`${key}.y`]: y, [`${key}.z`]: z };
}
