import type { Work } from '../../base/work.ts';

/** An LRU cache for expensive results: evicts the least recently used item. */
export class LruCache<Item> {
  private readonly capacity: number;
  private readonly items = new Map<string, Item>();

  /** @param capacity maximum number of items */
  constructor(capacity: number) {
    this.capacity = capacity;
  }

  get(key: string): Item | undefined {
    const item = this.items.get(key);
    if (item !== undefined) this.add(key, item);
    return item;
  }

  /** Returns an item, or makes it in pieces. */
  *making(key: string, make: () => Work<Item>): Work<Item> {
    const item = this.items.get(key) ?? (yield* make());
    this.add(key, item);
    return item;
  }

  add(key: string, item: Item): void {
    this.items.delete(key);
    this.items.set(key, item);
    if (this.items.size > this.capacity) this.items.delete(this.items.keys().next().value!);
  }
}
