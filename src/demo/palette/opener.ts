import { strings } from '../strings.ts';
import { create } from '../ui/dom.ts';
import { Progress } from '../ui/progress.ts';
import type { PaletteParts } from './lookDialog.ts';

/** File types for the file picker. */
export const COLOR_TYPES = '.gpl,.hex,.ase,.pal,.txt,.json,image/*';
/** Pictures that have no other use on the page. */
const ONLY_COLORS = /\.(gpl|hex|ase|pal|txt|jpe?g|webp|gif|avif|bmp)$/i;
/** Delay in milliseconds before a message appears. */
const DELAY_MS = 400;

/** Proposes looks in the colours of palettes and pictures. The code is fetched with the first file. */
export class Palettes {
  /** The file picker, which is not visible. */
  readonly element = create('input', {
    type: 'file',
    accept: COLOR_TYPES,
    hidden: true,
    'aria-label': strings.palette.open,
  });
  private readonly parts: PaletteParts;
  private readonly container: HTMLElement;
  private working: AbortController | undefined;

  /** @param container parent of the dialog and of the progress bar */
  constructor(parts: PaletteParts, container: HTMLElement) {
    this.parts = parts;
    this.container = container;
    this.element.addEventListener('change', () => {
      const file = this.element.files?.[0];
      if (file) void this.open(file);
      this.element.value = '';
    });
  }

  /** Opens the file picker. */
  choose(): void {
    this.element.click();
  }

  /** Whether a file has only colours to offer. JSON files are presets, takes or palettes. */
  async takes(file: File): Promise<boolean> {
    if (!/\.json$/i.test(file.name)) return ONLY_COLORS.test(file.name);
    const start = await file.slice(0, 4096).text();
    return /"colors"\s*:/.test(start) && !start.includes('"cartoon-smoke"');
  }

  /** Shows what a file proposes, or reports what is wrong with it. Opening another one cancels it. */
  async open(file: File): Promise<void> {
    this.working?.abort();
    const controller = (this.working = new AbortController());
    const { signal } = controller;
    const progress = new Progress(strings.palette.reading(file.name), () => controller.abort());
    const timer = setTimeout(() => this.container.append(progress.element), DELAY_MS);
    try {
      const { colorsOfFile, LookDialog } = await import('./lookDialog.ts');
      const found = await colorsOfFile(file, signal);
      signal.throwIfAborted();
      new LookDialog(found, file.name, this.parts).show(this.container, signal);
    } catch (error) {
      if (!signal.aborted) this.parts.notices.notify(strings.files.rejected(file.name, (error as Error).message));
    } finally {
      clearTimeout(timer);
      progress.element.remove();
    }
  }
}
