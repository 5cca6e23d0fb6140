import type { Editor } from '../editor/editor.ts';
import { strings } from '../strings.ts';
import { create, textButton } from '../ui/dom.ts';
import type { Notices } from '../ui/notices.ts';
import type { DrawSheet } from './sheet.ts';

/** Opens the sheet for drawing puffs, whose code is fetched on first use, and asks what pictures are for. */
export class DrawOpener {
  private readonly editor: Editor;
  private readonly notices: Notices;
  private readonly container: HTMLElement;
  private readonly onToggle: (isOpen: boolean) => void;
  private sheet: Promise<DrawSheet> | undefined;

  /**
   * @param container parent of the sheet
   * @param onToggle called before the sheet opens and after it has closed
   */
  constructor(editor: Editor, notices: Notices, container: HTMLElement, onToggle: (isOpen: boolean) => void) {
    this.editor = editor;
    this.notices = notices;
    this.container = container;
    this.onToggle = onToggle;
  }

  /** @param file a picture to begin with */
  async open(file?: File): Promise<void> {
    try {
      const sheet = await (this.sheet ??= this.load());
      this.onToggle(true);
      sheet.open();
      if (file) await sheet.import(file);
    } catch (error) {
      // Allow a retry after a failed fetch.
      this.sheet = undefined;
      this.notices.notify((error as Error).message);
    }
  }

  async close(): Promise<void> {
    (await this.sheet)?.close();
  }

  /**
   * Asks what dropped pictures are for.
   * @param openSheet uses them as the textures of puffs
   * @param takeColors uses the first one as a palette
   */
  ask(files: readonly File[], openSheet: () => void, takeColors: () => void): void {
    const { puff, sheet, palette } = strings.purpose;
    const [file] = files;
    const isSheet = files.every(({ name }) => /\.png$/i.test(name));
    const purposes: Purpose[] = [
      { words: puff, act: () => void this.open(file) },
      ...(isSheet ? [{ words: sheet, act: openSheet }] : []),
      { words: palette, act: takeColors },
    ];
    // Only sheets have several files.
    if (isSheet && files.length > 1) openSheet();
    else askPurpose(file, purposes, this.container);
  }

  private async load(): Promise<DrawSheet> {
    const { DrawSheet: Sheet } = await import('./sheet.ts');
    const sheet = new Sheet(this.editor, this.notices, () => this.onToggle(false));
    this.container.append(sheet.element);
    return sheet;
  }
}

/** Whether a file can be drawn on the sheet. */
export function isPicture({ name }: File): boolean {
  return /\.(png|svg)$/i.test(name);
}

/** A use of a file. */
interface Purpose {
  /** The name and an explanation. */
  readonly words: readonly [label: string, text: string];
  act(): void;
}

/** Asks what a file is for, in a dialog. @param container parent of the dialog */
function askPurpose(file: File, purposes: readonly Purpose[], container: HTMLElement): void {
  const heading = create('h2', { id: 'purpose-title' }, strings.purpose.title(file.name));
  const dialog = create('dialog', { class: 'sheet card', 'aria-labelledby': 'purpose-title' }, heading);
  for (const purpose of purposes) {
    const button = create('button', { type: 'button', class: 'purpose' }, create('strong', {}, purpose.words[0]));
    button.append(create('small', {}, purpose.words[1]));
    button.addEventListener('click', () => {
      dialog.close();
      purpose.act();
    });
    dialog.append(button);
  }
  dialog.append(textButton('quiet', strings.purpose.cancel, () => dialog.close()));
  dialog.addEventListener('close', () => dialog.remove());
  container.append(dialog);
  dialog.showModal();
}
