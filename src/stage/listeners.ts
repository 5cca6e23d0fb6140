/** A typed set of event listeners; `Events` maps event names to their details. */
export class Listeners<Events> {
  private readonly sets = new Map<keyof Events, Set<(detail: never) => void>>();

  /** @returns a function that removes the listener */
  add<Name extends keyof Events>(name: Name, listener: (detail: Events[Name]) => void): () => void {
    const set = this.sets.get(name) ?? new Set();
    this.sets.set(name, set.add(listener));
    return () => set.delete(listener);
  }

  has(name: keyof Events): boolean {
    return (this.sets.get(name)?.size ?? 0) > 0;
  }

  notify<Name extends keyof Events>(name: Name, detail: Events[Name]): void {
    for (const listener of this.sets.get(name) ?? []) (listener as (detail: Events[Name]) => void)(detail);
  }

  clear(): void {
    this.sets.clear();
  }
}
