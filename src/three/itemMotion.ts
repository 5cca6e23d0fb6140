import { MathUtils, Vector3, type Object3D } from 'three';
import type { AnyValues, NumberParameter, Values } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import type { Simulator } from '../simulator/simulator.ts';
import { simulatorValues } from '../simulator/simulatorValues.ts';
import { AXES } from '../simulator/emitterOptions.ts';
import type { SmokeFrame } from './smokeSpace.ts';
import type { Overrides } from './overrides.ts';
import type { ObjectPart, ObjectParts } from './objectParts.ts';
import { newPose } from './shapes.ts';

/** `WORLD` in Rust: the item rides on nothing. */
const NOWHERE = -1;
const WIND = 'forces.wind';

/** What item motion needs of its smoke. */
export interface ItemMotionContext {
  readonly simulator: Simulator;
  readonly parts: ObjectParts;
  readonly overrides: Overrides;
  readonly frame: SmokeFrame;
  /** Current values of the parameter table. */
  readonly values: () => Values;
}

/**
 * Moves the items of the parameter table with the object of world-space smoke, and keeps the wind of local smoke in its
 * direction of the world. Does nothing while the object has no transform.
 */
export class ItemMotion {
  private readonly context: ItemMotionContext;
  /** The smoke object, which the items ride on. */
  private part: ObjectPart | undefined;
  /** Items with places of their own. */
  private readonly free = new Set<string>();
  private isWindRotated = false;

  constructor(context: ItemMotionContext) {
    this.context = context;
  }

  /** Values have changed since the last look. */
  refresh(): void {
    if (this.part) this.carryItems();
  }

  /** Reads the transform of the object for the next steps. @throws ParameterError for an invalid one, see SmokeFrame.look */
  look(object: Object3D, steps: number, isFirst = false): void {
    const { frame } = this.context;
    try {
      frame.look(object, steps, isFirst);
    } finally {
      // The last valid transform, which ends the motion of before, if this one is not.
      if (frame.space === 'world' && frame.isMoved) this.carry(isFirst);
    }
  }

  /** Sets what the transform changes. Values may have changed, too. */
  private carry(isFirst: boolean): void {
    const { parts, frame } = this.context;
    // Until it moved, the object was at the origin.
    this.part ??= parts.add(newPose());
    parts.move(this.part, frame.object);
    if (isFirst) parts.move(this.part, frame.object);
    this.carryItems();
  }

  private carryItems(): void {
    const { simulator, overrides, values } = this.context;
    const items = new Set(Object.keys(values()).flatMap((key) => /^\w+\.\d+(?=\.)/.exec(key) ?? []));
    const numbers: Record<string, number> = {};
    for (const item of items) {
      if (item.startsWith('colliders.')) Object.assign(numbers, this.obstacle(item));
      else if (findParameter(`${item}.rigid`)) numbers[`${item}.rigid`] = this.numberOf(`${item}.rigid`);
    }
    simulator.set(overrides.over(numbers));
  }

  /** Prepares a step. @param share how far its middle is on the way between the last two looks */
  place(share: number): void {
    const { simulator, frame } = this.context;
    if (frame.space === 'world') return;
    const wind = this.vectorOf(WIND);
    const rotated = wind.lengthSq() > 0 ? frame.rotated(wind, share) : undefined;
    if (!rotated && !this.isWindRotated) return;
    this.isWindRotated = rotated !== undefined;
    simulator.set(directionNumbers(WIND, rotated ?? wind));
  }

  /** Gives an item a place of its own. */
  release(item: string): void {
    this.free.add(item);
  }

  /** The simulator's number for a key of the table, without overrides. */
  numberOf(key: string): number {
    const number = simulatorValues({ [key]: (this.context.values() as AnyValues)[key] ?? findParameter(key)!.default })[
      key
    ];
    const isCarried = this.part && key.endsWith('.rigid') && !this.free.has(key.slice(0, -'.rigid'.length));
    return isCarried && number === NOWHERE ? this.part!.number : number;
  }

  /** Numbers of an obstacle, which cannot ride. */
  private obstacle(item: string): Record<string, number> {
    const { position, rotation } = this.context.frame.object;
    const place = this.vectorOf(`${item}.position`).applyQuaternion(rotation).add(position);
    const axis = this.vectorOf(`${item}.axis`).applyQuaternion(rotation);
    return { ...numbersOf(`${item}.position`, place), ...directionNumbers(`${item}.axis`, axis) };
  }

  private vectorOf(key: string): Vector3 {
    return new Vector3(...AXES.map((axis) => this.numberOf(`${key}.${axis}`)));
  }
}

/** Numbers of a direction, shortened to the range of its parameters. */
function directionNumbers(key: string, vector: Vector3): Record<string, number> {
  const most = Math.max(...AXES.map((axis) => Math.abs(vector[axis])));
  return numbersOf(key, vector.multiplyScalar(Math.min(1, rangeOf(key).max / most)));
}

/** Numbers of a vector, within the range of its parameters. */
function numbersOf(key: string, vector: Vector3): Record<string, number> {
  const { min, max } = rangeOf(key);
  return Object.fromEntries(AXES.map((axis) => [`${key}.${axis}`, MathUtils.clamp(vector[axis], min, max)]));
}

function rangeOf(key: string): NumberParameter {
  return findParameter(`${key}.x`) as NumberParameter;
}
