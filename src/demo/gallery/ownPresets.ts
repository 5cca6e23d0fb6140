import type { Stage } from '../../index.ts';
import { MAX_NAME, nameOf } from '../../internal.ts';
import { findPreset, readFile, writeFile, SmokeError } from '../../preset.ts';
import { create, iconButton, textButton } from '../ui/dom.ts';
import type { Editor } from '../editor/editor.ts';
import { saveText } from '../share/files.ts';
import { icon } from '../ui/icons.ts';
import type { Notices } from '../ui/notices.ts';
import { strings } from '../strings.ts';

const words = strings.own;

/** The user's stored presets as cards: select, rename, save and remove them, and store new ones. */
export class OwnPresets {
  /** Element for the panel. */
  readonly element: HTMLElement;
  private readonly editor: Editor;
  private readonly stage: Stage;
  private readonly notices: Notices;
  private readonly presetStorage = localPresetStorage();
  private readonly cards = create('ul', { class: 'own-cards' });
  private readonly keepButton = textButton('quiet', words.keep, () => void this.attempt(() => this.keep()));

  /** @param opener the button that opens files */
  constructor(editor: Editor, stage: Stage, notices: Notices, opener: HTMLElement) {
    this.editor = editor;
    this.stage = stage;
    this.notices = notices;
    const buttons = create('div', { class: 'own-buttons' }, this.keepButton, opener);
    const attributes = { class: 'own-presets', role: 'group', 'aria-label': words.title, 'data-text': words.text };
    this.element = create('div', attributes, create('h3', {}, words.title), this.cards, buttons);
    this.presetStorage.onChange = () => this.show();
    if (this.presetStorage.error !== undefined) notices.notify(this.presetStorage.error);
    this.show();
  }

  private show(): void {
    this.cards.replaceChildren(...this.presetStorage.all.map((kept) => this.createCard(kept)));
    this.cards.hidden = this.presetStorage.all.length === 0;
  }

  private async keep(): Promise<void> {
    const { state } = this.editor;
    const preset = findPreset(state.preset)?.label ?? strings.title;
    const name = words.numbered(
      preset,
      this.presetStorage.all.filter(({ name: other }) => other.startsWith(preset)).length + 1,
    );
    const picture = await shrink(await this.stage.picture());
    const kept = this.presetStorage.keep(name, await writeFile({ name, state }, ''), picture);
    this.notices.mention(words.kept(kept.name));
    if (state.model) this.notices.notify(strings.model.notKept(state.model.name));
  }

  private createCard(kept: StoredPreset): HTMLElement {
    const { id, name } = kept;
    const picture = createThumbnail();
    void drawThumbnail(picture, kept.picture);
    const label = create('span', {}, name);
    const show = create('button', { type: 'button', class: 'own-show' }, picture, label);
    show.addEventListener('click', () => void this.attempt(() => this.open(kept)));
    const rename = iconButton('icon-button', words.rename(name), icon('rename'), () => this.rename(card, kept));
    const save = iconButton('icon-button', words.save(name), icon('download'), () => this.save(kept));
    const remove = iconButton('icon-button', words.remove(name), icon('remove'), () => this.remove(kept));
    const card = create('li', { 'data-id': id }, show, create('div', {}, rename, save, remove));
    return card;
  }

  private async open({ file, name }: StoredPreset): Promise<void> {
    const { state, notices } = await readFile(file);
    for (const { message } of notices) this.notices.notify(message);
    this.editor.load(state);
    this.notices.mention(strings.files.opened(name));
  }

  /** Edits the name in place. Enter and blur confirm, Escape cancels. */
  private rename(card: HTMLElement, { id, name }: StoredPreset): void {
    const field = create('input', { type: 'text', value: name, maxlength: MAX_NAME, 'aria-label': words.newName });
    let isDone = false;
    const finish = (isConfirmed: boolean) => {
      if (isDone) return;
      isDone = true;
      void this.attempt(() => (isConfirmed ? this.presetStorage.rename(id, nameOf(field.value)) : this.show()));
      this.focusOn(id);
    };
    field.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== 'Escape') return;
      event.stopPropagation();
      // The key's default action would apply to the newly focused element: Enter would click the card.
      event.preventDefault();
      finish(event.key === 'Enter');
    });
    field.addEventListener('blur', () => finish(true));
    card.append(field);
    field.select();
    field.focus();
  }

  private save({ file, name }: StoredPreset): void {
    void this.attempt(async () => void (await saveText(file, name)));
  }

  private remove({ id, name }: StoredPreset): void {
    void this.attempt(() => {
      const bringBack = this.presetStorage.remove(id);
      this.notices.offer(words.removed(name), words.bringBack, () => void this.attempt(bringBack));
      this.keepButton.focus();
    });
  }

  private focusOn(id: string): void {
    this.cards.querySelector<HTMLElement>(`[data-id="${CSS.escape(id)}"] .own-show`)?.focus();
  }

  /** Shows the error of a failed action, which has changed nothing. */
  private async attempt(action: () => void | Promise<void>): Promise<void> {
    try {
      await action();
    } catch (error) {
      this.notices.notify((error as Error).message);
    }
  }
}

/** Thumbnails, encoded to fit into the browser's storage. Size in pixels. */

const [WIDTH, HEIGHT] = [160, 100];
const QUALITY = 0.8;
/** Visible fraction of the frame, from its centre, so that the thumbnail shows the smoke and not the room. */
const SHOWN = 0.72;

/** Crops and scales a frame to a thumbnail, as base64. */
async function shrink(picture: Blob): Promise<string> {
  const whole = await createImageBitmap(picture);
  const scale = SHOWN * Math.min(whole.width / WIDTH, whole.height / HEIGHT);
  const [width, height] = [WIDTH * scale, HEIGHT * scale];
  const canvas = createThumbnail();
  const context = canvas.getContext('2d')!;
  context.imageSmoothingQuality = 'high';
  const [left, top] = [(whole.width - width) / 2, (whole.height - height) / 2];
  context.drawImage(whole, left, top, width, height, 0, 0, WIDTH, HEIGHT);
  whole.close();
  return canvas.toDataURL('image/webp', QUALITY).split(',')[1];
}

/** Draws a thumbnail from `shrink`. Invalid data leaves the canvas empty. It never loads a URL. */
async function drawThumbnail(canvas: HTMLCanvasElement, picture: string): Promise<void> {
  try {
    const bytes = Uint8Array.from(atob(picture), (character) => character.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes]));
    canvas.getContext('2d')!.drawImage(image, 0, 0, WIDTH, HEIGHT);
    image.close();
  } catch {
    canvas.classList.add('is-empty');
  }
}

/** Creates an empty thumbnail. */
function createThumbnail(): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [WIDTH, HEIGHT];
  return canvas;
}

/** Presets of the user, stored in the browser. Unreadable data is moved aside, not deleted. */

/** A stored preset. */
interface StoredPreset {
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
class PresetStorage {
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
function localPresetStorage(): PresetStorage {
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
