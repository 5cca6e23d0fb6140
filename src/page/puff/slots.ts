import { LIST_LIMIT } from '../../parameters/lists.ts';

/** The items of a list of the parameter table, handed out to calls. When there are too many, the oldest goes. */
export class Slots {
  private readonly taken: (object | undefined)[] = Array.from({ length: LIST_LIMIT });
  private next = 0;

  /** @returns the index of an item. @param owner frees it */
  claim(owner: object): number {
    const free = this.taken.indexOf(undefined);
    const index = free >= 0 ? free : this.next++ % LIST_LIMIT;
    this.taken[index] = owner;
    return index;
  }

  /** @returns the indices that an owner had; all without one */
  release(owner?: object): number[] {
    const gone = this.taken.flatMap((each, index) => (each && (!owner || each === owner) ? [index] : []));
    for (const index of gone) this.taken[index] = undefined;
    return gone;
  }
}
