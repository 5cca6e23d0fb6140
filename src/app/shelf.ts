/** Presets of the visitor's own, kept in the browser. Nothing is thrown away: what cannot be read is set aside. */
import { SmokeError } from '../preset/errors.ts';
import { nameOf } from '../preset/file.ts';
import { strings } from './strings.ts';

/** One of them. */
export interface Kept {
  readonly id: string;
  readonly name: string;
  /** As a file holds it. */
  readonly file: string;
  /** A small picture as base64, in a format that browsers know; empty for none. */
  readonly picture: string;
}

const KEY = 'cartoon-smoke.presets';
const SET_ASIDE = 'cartoon-smoke.presets.damaged';

/** The presets in the order in which they were kept. Other tabs of the same site have the same ones. */
export class Shelf {
  /** Told after each change, also of another tab. */
  onChange: () => void = () => undefined;
  /** What could not be read, for people; undefined where all could. */
  readonly complaint: string | undefined;
  private kept: readonly Kept[] = [];
  private readonly storage: Storage | undefined;

  /** @param storage undefined where the browser lets the page keep nothing */
  constructor(storage: Storage | undefined) {
    this.storage = storage;
    this.complaint = this.read();
    globalThis.addEventListener?.('storage', ({ key }) => {
      if (key !== KEY) return;
      this.read();
      this.onChange();
    });
  }

  get all(): readonly Kept[] {
    return this.kept;
  }

  /** @throws SmokeError when the browser keeps no more; nothing has changed then */
  keep(name: string, file: string, picture: string): Kept {
    const kept = { id: crypto.randomUUID(), name: nameOf(name), file, picture };
    this.write([...this.kept, kept]);
    return kept;
  }

  /** @throws SmokeError when the browser keeps no more; nothing has changed then */
  rename(id: string, name: string): void {
    this.write(this.kept.map((kept) => (kept.id === id ? { ...kept, name: nameOf(name) } : kept)));
  }

  /** @returns what brings it back to where it was */
  remove(id: string): () => void {
    const at = this.kept.findIndex((kept) => kept.id === id);
    const removed = this.kept[at];
    this.write(this.kept.filter((kept) => kept !== removed));
    return () => this.write([...this.kept.slice(0, at), removed, ...this.kept.slice(at)]);
  }

  private write(next: readonly Kept[]): void {
    try {
      if (!this.storage) throw new SmokeError(strings.own.noStorage);
      this.storage.setItem(KEY, JSON.stringify(next));
    } catch (error) {
      if (error instanceof SmokeError) throw error;
      throw new SmokeError(strings.own.full, { cause: error });
    }
    this.kept = next;
    this.onChange();
  }

  private read(): string | undefined {
    const text = this.storage?.getItem(KEY) ?? '[]';
    const found = parsed(text);
    this.kept = Array.isArray(found) ? found.filter(isKept) : [];
    if (Array.isArray(found) && found.length === this.kept.length) return undefined;
    this.storage?.setItem(SET_ASIDE, text);
    return strings.own.damaged(SET_ASIDE);
  }
}

/** The browser's own storage; undefined where it refuses, as in frames of some sites. */
export function localShelf(): Shelf {
  try {
    return new Shelf(localStorage);
  } catch {
    return new Shelf(undefined);
  }
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

function isKept(value: unknown): value is Kept {
  if (typeof value !== 'object' || value === null) return false;
  const { id, name, file, picture } = value as Partial<Record<keyof Kept, unknown>>;
  return [id, name, file, picture].every((part) => typeof part === 'string');
}
