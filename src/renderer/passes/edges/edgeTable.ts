/** Spreads the bits of a hash, so that similar values are far apart (half of Appleby, MurmurHash3, 2008). */
export function mixed(hash: number): number {
  const spread = Math.imul(hash ^ (hash >>> 16), 0x85ebca6b);
  return spread ^ (spread >>> 13);
}

/** Numbers pairs of vertices in the order in which they are added. A hash table with open addressing. */
export class EdgeTable {
  /** Number of different edges. */
  count = 0;
  private readonly slots: Int32Array;
  private readonly ends: Uint32Array;

  /** @param capacity maximum number of edges */
  constructor(capacity: number) {
    this.slots = new Int32Array(2 ** Math.ceil(Math.log2(2 * capacity + 1))).fill(-1);
    this.ends = new Uint32Array(2 * capacity);
  }

  /** The number of an edge, which is `count` before the call if the edge is new. */
  add(start: number, end: number): number {
    const slot = this.slotOf(start, end);
    if (this.slots[slot] >= 0) return this.slots[slot];
    this.ends[2 * this.count] = start;
    this.ends[2 * this.count + 1] = end;
    this.slots[slot] = this.count++;
    return this.slots[slot];
  }

  /** The number of an edge, or -1. */
  find(start: number, end: number): number {
    return this.slots[this.slotOf(start, end)];
  }

  private slotOf(start: number, end: number): number {
    const { slots, ends } = this;
    let slot = mixed(Math.imul(start, 73856093) ^ Math.imul(end, 19349663)) & (slots.length - 1);
    while (slots[slot] >= 0 && (ends[2 * slots[slot]] !== start || ends[2 * slots[slot] + 1] !== end)) {
      slot = (slot + 1) & (slots.length - 1);
    }
    return slot;
  }
}
