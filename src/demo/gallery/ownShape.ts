import { fitPuff, type Stage } from '../../index.ts';
import { create, textButton } from '../ui/dom.ts';
import { MESH_TYPES, readMesh } from './meshFile.ts';
import type { Notices } from '../ui/notices.ts';
import { Progress } from '../ui/progress.ts';
import { strings } from '../strings.ts';

/** A mesh from the user as puff shape: chosen in the panel or dropped onto the page, and removable. */
export class OwnShape {
  /** Element for the panel. */
  readonly element: HTMLElement;
  private readonly stage: Stage;
  private readonly notices: Notices;
  private readonly container: HTMLElement;
  private readonly caption = create('p', { class: 'own-shape-name', role: 'status' });
  private readonly back = textButton('quiet', strings.ownShape.back, () => this.cancelFit());
  private fitting: AbortController | undefined;
  private shown: string | undefined;

  /** @param container parent of the progress bar */
  constructor(stage: Stage, notices: Notices, container: HTMLElement) {
    this.stage = stage;
    this.notices = notices;
    this.container = container;
    const chooser = create('input', {
      type: 'file',
      accept: MESH_TYPES,
      hidden: true,
      'aria-label': strings.ownShape.choose,
    });
    chooser.addEventListener('change', () => {
      const file = chooser.files?.[0];
      if (file) void this.open(file);
      chooser.value = '';
    });
    const choose = textButton('quiet', strings.ownShape.choose, () => chooser.click());
    const buttons = create('div', { class: 'own-shape-buttons' }, choose, this.back);
    this.element = create('div', { 'data-text': strings.ownShape.text }, this.caption, buttons, chooser);
    this.notify();
  }

  /** Name of the file whose shape is shown. */
  get name(): string | undefined {
    return this.shown;
  }

  /** Shows the mesh of a file, or reports why it cannot. Opening another file cancels a fit in progress. */
  async open(file: File): Promise<void> {
    this.fitting?.abort();
    const controller = (this.fitting = new AbortController());
    const progress = new Progress(strings.ownShape.fitting(file.name), () => controller.abort());
    this.container.append(progress.element);
    try {
      const { shape, overlap } = await fitPuff(await readMesh(file), { name: file.name, signal: controller.signal });
      this.stage.setPuffs([shape]);
      this.shown = file.name;
      this.notify(overlap);
    } catch (error) {
      if (!controller.signal.aborted) this.notices.notify((error as Error).message);
    } finally {
      progress.element.remove();
    }
  }

  private cancelFit(): void {
    this.stage.setPuffs();
    this.shown = undefined;
    this.notify();
  }

  private notify(overlap = 0): void {
    this.caption.textContent = this.shown === undefined ? '' : strings.ownShape.shown(this.shown, overlap);
    this.caption.hidden = this.back.hidden = this.shown === undefined;
  }
}
