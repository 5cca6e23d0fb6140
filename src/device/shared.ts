interface Held<Item> {
  readonly item: Item;
  holders: number;
}

/** What stands on a device once for all that use it: made for the first, disposed of after the last. */
export class Shared<Key extends object, Item extends { dispose(): void }> {
  private readonly make: (key: Key) => Item;
  private readonly held = new Map<Key, Held<Item>>();

  constructor(make: (key: Key) => Item) {
    this.make = make;
  }

  /** How many different things are held. */
  get size(): number {
    return this.held.size;
  }

  /** The item of a key, which has to be released as often as it was held. */
  hold(key: Key): Item {
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

  /** Disposes of all items where they are; they stay held. */
  dispose(): void {
    for (const { item } of this.held.values()) item.dispose();
  }
}
