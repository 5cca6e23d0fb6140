/** Saves and opens presets and takes as files. */
import type { Stage } from '../../index.ts';
import { nameOf } from '../../internal.ts';
import { FileError, findPreset, readFile, writeFile, type SmokeFile, type State } from '../../preset.ts';
import { create, textButton, download } from '../ui/dom.ts';
import type { Editor } from '../editor/editor.ts';
import { goToMoment } from './moment.ts';
import type { Notices } from '../ui/notices.ts';
import type { ShareKind } from './shareKind.ts';
import { strings } from '../strings.ts';

/** Maximum file size in bytes. A take that starts with 100,000 particles and a model of 32 MB are smaller together. */
const MAX_BYTES = 64 * 1024 * 1024;
const SCHEMA = 'smoke-file.schema.json';

/** Dependencies of SmokeFiles. */
interface FileParts {
  readonly editor: Editor;
  readonly stage: Stage;
  readonly notices: Notices;
}

/** Saves the current smoke to files and opens files. */
export class SmokeFiles {
  private readonly editor: Editor;
  private readonly stage: Stage;
  private readonly notices: Notices;
  private readonly container: HTMLElement;

  /** @param container parent of the progress bar */
  constructor({ editor, stage, notices }: FileParts, container: HTMLElement) {
    this.editor = editor;
    this.stage = stage;
    this.notices = notices;
    this.container = container;
  }

  /** Downloads a file of the current smoke. @returns its name */
  async save(what: ShareKind): Promise<string> {
    const name = findPreset(this.editor.state.preset)?.label ?? strings.title;
    const moment = { take: this.stage.take().toBytes(), seconds: this.stage.stats.time };
    const { state } = this.editor;
    const file = { name, state, model: state.model, ...(what === 'moment' && { moment }) };
    return saveFile(file, what === 'moment' ? 'take' : 'preset');
  }

  /** Opens a file, or reports what is wrong with it. The previous state can be restored by undo. */
  async open(file: File): Promise<void> {
    try {
      if (file.size > MAX_BYTES) throw new FileError(strings.files.tooLarge(MAX_BYTES / 1024 / 1024));
      const { state, moment, model, notices, name } = await readFile(await file.text());
      for (const { message } of notices) this.notices.notify(message);
      if (model !== this.editor.state.model) await this.editor.setModel(model, state);
      else this.editor.load(state);
      if (moment) await this.goTo(moment, state);
      else this.notices.mention(strings.files.opened(name));
    } catch (error) {
      this.notices.notify(strings.files.rejected(file.name, (error as Error).message));
    }
  }

  private async goTo({ take, seconds }: NonNullable<SmokeFile['moment']>, state: State): Promise<void> {
    // Edits that the stage applies later would count as input to the take.
    await this.editor.delivered();
    await goToMoment(this.stage, { take, seconds, state, isTrusted: true }, this.notices, this.container);
  }
}

/** Downloads a file. @returns its name */
export async function saveFile(file: SmokeFile, kind: 'preset' | 'take'): Promise<string> {
  const name = `${slug(file.name)}.${kind}.json`;
  download(name, await writeFile(file, new URL(SCHEMA, document.baseURI).href));
  return name;
}

/** Downloads the text of a stored file under its current name. */
export async function saveText(text: string, name: string): Promise<string> {
  return saveFile({ ...(await readFile(text)), name }, 'preset');
}

/** Converts a name to a valid file name. */
function slug(name: string): string {
  const plain = nameOf(name).toLowerCase().normalize('NFKD');
  return plain.replace(/[^\p{L}\p{N}]+/gu, '-').replace(/^-|-$/g, '') || 'smoke';
}

/** A button that opens the file picker. @param open takes at least one file */
export function createOpener(accept: string, open: (files: readonly File[]) => void): HTMLElement {
  const chooser = create('input', { type: 'file', accept, hidden: true, 'aria-label': strings.files.open });
  chooser.addEventListener('change', () => {
    const files = [...(chooser.files ?? [])];
    if (files.length > 0) open(files);
    chooser.value = '';
  });
  const button = textButton('quiet', strings.files.open, () => chooser.click());
  return create('span', {}, button, chooser);
}

/** Accepts files that are dropped anywhere on the page. @param open takes at least one file */
export function acceptDrops(page: HTMLElement, open: (files: readonly File[]) => void): void {
  page.addEventListener('dragover', (event) => {
    if (!event.dataTransfer?.types.includes('Files')) return;
    event.preventDefault();
    page.classList.add('is-dropping');
  });
  page.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) page.classList.remove('is-dropping');
  });
  page.addEventListener('drop', (event) => {
    page.classList.remove('is-dropping');
    const files = [...(event.dataTransfer?.files ?? [])];
    if (files.length === 0) return;
    event.preventDefault();
    open(files);
  });
}
