/** Things that were dear to make, by what they were made from; the one that was longest not asked for goes first. */
export class LruCache<Item> {
  private readonly capacity: number;
  private readonly items = new Map<string, Item>();

  /** @param capacity the most that are kept */
  constructor(capacity: number) {
    this.capacity = capacity;
  }

  get(key: string): Item | undefined {
    const item = this.items.get(key);
    if (item !== undefined) this.add(key, item);
    return item;
  }

  add(key: string, item: Item): void {
    this.items.delete(key);
    this.items.set(key, item);
    if (this.items.size > this.capacity) this.items.delete(this.items.keys().next().value!);
  }
}
