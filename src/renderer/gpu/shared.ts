interface Held<Item> {
  readonly item: Item;
  holders: number;
}

/** Reference-counted resources of a device: created on first use, disposed of after the last release. */
export class Shared<Key extends object, Item extends { dispose(): void }> {
  private readonly make: (key: Key) => Item;
  private readonly held = new Map<Key, Held<Item>>();

  constructor(make: (key: Key) => Item) {
    this.make = make;
  }

  /** Number of distinct resources. */
  get size(): number {
    return this.held.size;
  }

  /** Returns the item of a key. Each call needs a matching `release`. */
  acquire(key: Key): Item {
    const held = this.held.get(key) ?? { item: this.make(key), holders: 0 };
    held.holders += 1;
    this.held.set(key, held);
    return held.item;
  }

  release(key: Key): void {
    const held = this.held.get(key)!;
    held.holders -= 1;
    if (held.holders > 0) return;
    held.item.dispose();
    this.held.delete(key);
  }

  /** Disposes of all items but keeps the references: items recreate their GPU resources when they are next drawn. */
  dispose(): void {
    for (const { item } of this.held.values()) item.dispose();
  }
}
