import { FileError, type ModelFile } from '../../preset.ts';
import { strings } from '../strings.ts';
import { create, textButton } from '../ui/dom.ts';
import type { ModelParts, ModelRows } from './modelRows.ts';

/** Maximum file size in bytes, as of stages: larger files are not even read. */
const MAX_BYTES = 32 * 1024 * 1024;
/** Longest side of a model, as a share of the height of the picture. */
const SHARE = 0.4;
const words = strings.model;

/** The section of the panel for a GLB model in the scene: chosen there or dropped onto the page, and removable. */
export class Models {
  /** Element for the panel. */
  readonly element = create('details', { class: 'group', 'data-text': words.text });
  private readonly parts: ModelParts;
  private readonly caption = create('p', { class: 'own-model-name', role: 'status' });
  private readonly holder = create('div', {});
  private readonly removal = textButton('quiet', words.remove, () => void this.remove());
  private rows: Promise<ModelRows> | undefined;

  constructor(parts: ModelParts) {
    this.parts = parts;
    const chooser = create('input', { type: 'file', accept: '.glb', hidden: true, 'aria-label': words.choose });
    chooser.addEventListener('change', () => {
      const file = chooser.files?.[0];
      if (file) void this.open(file);
      chooser.value = '';
    });
    const choose = textButton('quiet', words.choose, () => chooser.click());
    const buttons = create('div', { class: 'own-shape-buttons' }, choose, this.removal);
    this.element.append(create('summary', {}, words.title), this.caption, this.holder, buttons, chooser);
    parts.editor.listen(() => void this.show());
    parts.stage.on('statechange', () => void this.show());
    void this.show();
  }

  /** Name of the model, if the scene has one. */
  get name(): string | undefined {
    return this.parts.editor.state.model?.name;
  }

  /** Adds the model of a file in the middle of the view, or reports why it cannot. */
  async open(file: File): Promise<void> {
    const { editor, notices } = this.parts;
    try {
      if (file.size > MAX_BYTES)
        throw new FileError(words.tooLarge(Math.ceil(file.size / 1024 / 1024), MAX_BYTES / 1024 / 1024));
      const bytes = new Uint8Array(await file.arrayBuffer());
      await editor.setModel({ name: file.name.slice(0, 60), bytes, options: this.place() });
      notices.mention(words.placed(file.name));
      this.element.open = true;
      await this.show();
      this.element.scrollIntoView();
    } catch (error) {
      notices.notify(strings.files.rejected(file.name, (error as Error).message));
    }
  }

  private async remove(): Promise<void> {
    const { editor, notices } = this.parts;
    try {
      await editor.setModel(undefined);
      this.element.querySelector('summary')!.focus();
    } catch (error) {
      notices.notify((error as Error).message);
    }
  }

  /** A place in the middle of the view, rounded, so that it can be edited and is the same in another scene. */
  private place(): ModelFile['options'] {
    const { middle, up } = this.parts.stage.sight.plane;
    const size = rounded(SHARE * this.parts.canvas.clientHeight * Math.hypot(...up), 2);
    const [x, y, z] = middle.map((along, axis) => rounded(axis === 1 ? along - size / 2 : along, 3));
    return { position: { x, y, z }, size };
  }

  private async show(): Promise<void> {
    const { editor, stage } = this.parts;
    const [{ model: file }, { model }] = [editor.state, stage];
    this.removal.hidden = this.holder.hidden = !file || !model;
    this.caption.textContent =
      file && model ? words.shown(file.name, model.triangles, model.materials, model.box) : words.none;
    if (!file || !model) return (await this.rows)?.hide();
    this.rows ??= this.load();
    (await this.rows)?.show(file, model);
  }

  /** Fetches the rows, which only pages with a model need. */
  private async load(): Promise<ModelRows> {
    const { ModelRows: Rows } = await import('./modelRows.ts');
    const rows = new Rows(this.parts);
    this.holder.append(rows.element);
    return rows;
  }
}

function rounded(value: number, digits: number): number {
  return Number(value.toFixed(digits));
}

/** Whether a file is a model for the scene. */
export function isModel({ name }: File): boolean {
  return /\.glb$/i.test(name);
}
