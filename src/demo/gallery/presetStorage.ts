/** Presets of the user, stored in the browser. Unreadable data is moved aside, not deleted. */
import { nameOf } from '../../internal.ts';
import { SmokeError } from '../../preset.ts';
import { strings } from '../strings.ts';

/** A stored preset. */
export interface StoredPreset {
  readonly id: string;
  readonly name: string;
  /** Content of the preset file. */
  readonly file: string;
  /** Thumbnail as base64, in an image format that browsers support; empty for none. */
  readonly picture: string;
}

const KEY = 'cartoon-smoke.presets';
const SET_ASIDE = 'cartoon-smoke.presets.damaged';

/** The presets in the order of storage, shared between tabs of the same origin. */
export class PresetStorage {
  /** Called after each change, including changes in another tab. */
  onChange: () => void = () => undefined;
  /** Message about unreadable data; undefined when all data was read. */
  readonly error: string | undefined;
  private stored: readonly StoredPreset[] = [];
  private readonly storage: Storage | undefined;

  /** @param storage undefined where the browser denies storage to the page */
  constructor(storage: Storage | undefined) {
    this.storage = storage;
    this.error = this.read();
    globalThis.addEventListener?.('storage', ({ key }) => {
      if (key !== KEY) return;
      this.read();
      this.onChange();
    });
  }

  get all(): readonly StoredPreset[] {
    return this.stored;
  }

  /** @throws SmokeError when the storage is full; nothing has changed then */
  keep(name: string, file: string, picture: string): StoredPreset {
    const stored = { id: crypto.randomUUID(), name: nameOf(name), file, picture };
    this.write([...this.stored, stored]);
    return stored;
  }

  /** @throws SmokeError when the storage is full; nothing has changed then */
  rename(id: string, name: string): void {
    this.write(this.stored.map((stored) => (stored.id === id ? { ...stored, name: nameOf(name) } : stored)));
  }

  /** @returns a function that restores it at its position */
  remove(id: string): () => void {
    const at = this.stored.findIndex((stored) => stored.id === id);
    const removed = this.stored[at];
    this.write(this.stored.filter((stored) => stored !== removed));
    return () => this.write([...this.stored.slice(0, at), removed, ...this.stored.slice(at)]);
  }

  private write(next: readonly StoredPreset[]): void {
    try {
      if (!this.storage) throw new SmokeError(strings.own.noStorage);
      this.storage.setItem(KEY, JSON.stringify(next));
    } catch (error) {
      if (error instanceof SmokeError) throw error;
      throw new SmokeError(strings.own.full, { cause: error });
    }
    this.stored = next;
    this.onChange();
  }

  private read(): string | undefined {
    const text = this.storage?.getItem(KEY) ?? '[]';
    const found = parsed(text);
    this.stored = Array.isArray(found) ? found.filter(isStoredPreset) : [];
    if (Array.isArray(found) && found.length === this.stored.length) return undefined;
    this.storage?.setItem(SET_ASIDE, text);
    return strings.own.damaged(SET_ASIDE);
  }
}

/** Storage on the browser's localStorage; without it where access is denied, for example in cross-site frames. */
export function localPresetStorage(): PresetStorage {
  try {
    return new PresetStorage(localStorage);
  } catch {
    return new PresetStorage(undefined);
  }
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

function isStoredPreset(value: unknown): value is StoredPreset {
  if (typeof value !== 'object' || value === null) return false;
  const { id, name, file, picture } = value as Partial<Record<keyof StoredPreset, unknown>>;
  return [id, name, file, picture].every((part) => typeof part === 'string');
}
