import { findParameter } from '../parameters/table.ts';
import type { Simulator } from '../simulator/simulator.ts';

/** An envelope that ends as soon as it has started, which no value of the table could do for all of a long run. */
const SILENCE: Readonly<Record<string, number>> = {
  'envelope.duration': 1e-9,
  'envelope.period': 0,
  'burst.count': 0,
  perMetre: 0,
};

/**
 * Numbers that handles set in the simulator in place of the values of the parameter table, which stay as the caller has
 * set them.
 */
export class Overrides {
  private readonly simulator: Simulator;
  private readonly numberOf: (key: string) => number;
  private readonly numbers = new Map<string, number>();
  /** Number of active users by item of the table. */
  private readonly users = new Map<string, number>();
  /** Items that have an effect only while they have users. */
  private readonly reserved = new Set<string>();

  /** @param numberOf the number of a key without an override */
  constructor(simulator: Simulator, numberOf: (key: string) => number) {
    this.simulator = simulator;
    this.numberOf = numberOf;
  }

  put(key: string, number: number): void {
    this.simulator.set({ [key]: number });
    this.numbers.set(key, number);
  }

  drop(key: string): void {
    if (!this.numbers.delete(key)) return;
    this.simulator.set({ [key]: this.numberOf(key) });
  }

  /** Adds a user of an item, such as `emitters.0`, that has an envelope. */
  unmute(item: string): void {
    this.users.set(item, (this.users.get(item) ?? 0) + 1);
    this.restore(item);
  }

  /** Removes a user. Without users, the item has no effect. */
  mute(item: string): void {
    this.users.set(item, (this.users.get(item) ?? 0) - 1);
    this.silence(item);
  }

  /** Whether an item is reserved and has no users. */
  isSilent(item: string): boolean {
    return this.reserved.has(item) && !this.users.get(item);
  }

  /** From now on the item has an effect only while it has users. */
  reserve(item: string): void {
    if (this.reserved.has(item)) return;
    this.reserved.add(item);
    this.silence(item);
  }

  /** Gives an item the effect that its values describe, unless it is reserved and has no users. */
  restore(item: string): void {
    if (this.isSilent(item)) return;
    for (const key in SILENCE) this.drop(`${item}.${key}`);
  }

  private silence(item: string): void {
    if (this.users.get(item)) return;
    for (const key in SILENCE) if (findParameter(`${item}.${key}`)) this.put(`${item}.${key}`, SILENCE[key]);
  }

  /** Sets `numbers`, and all overrides in place of what they replace. */
  setAll(numbers: Record<string, number>): void {
    this.simulator.set({ ...numbers, ...Object.fromEntries(this.numbers) });
  }

  /** `numbers`, with overrides in place of what they replace. */
  over(numbers: Record<string, number>): Record<string, number> {
    for (const key in numbers) numbers[key] = this.numbers.get(key) ?? numbers[key];
    return numbers;
  }
}
