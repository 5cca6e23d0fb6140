import type { Stage } from '../../index.ts';
import type { Task } from '../../internal.ts';
import { create, textButton, download } from '../ui/dom.ts';
import { Progress } from '../ui/progress.ts';
import { strings } from '../strings.ts';
import { capture } from './capture.ts';
import { SettingsForm } from './settingsForm.ts';
import { isCompared, type CaptureSettings, type Format } from './settings.ts';
import type { Compared } from './compare.ts';

/** Dialog that selects what to capture, shows progress and allows cancelling. The smoke is paused meanwhile. */
export class CaptureDialog {
  readonly element: HTMLDialogElement;
  private readonly stage: Stage;
  private readonly form = new SettingsForm();
  private readonly outcome = create('div', { class: 'capture-outcome', role: 'status' });
  /** Files that wait to be saved, with their sizes. */
  private readonly files = create('div', { class: 'capture-files' });
  private readonly start = create('button', { type: 'submit', class: 'loud' }, strings.capture.start);
  private readonly compare = textButton('quiet', strings.capture.compare, () => void this.runComparison());
  private work: AbortController | undefined;
  private wasPlaying: boolean | undefined;

  constructor(stage: Stage) {
    this.stage = stage;
    const { title } = strings.capture;
    const close = textButton('quiet', strings.help.close, () => this.element.close());
    const buttons = create('div', { class: 'capture-buttons' }, this.start, this.compare, close);
    this.form.element.append(this.outcome, this.files, buttons);
    const heading = create('h2', { id: 'capture-title' }, title);
    const attributes = { class: 'sheet card capture', 'aria-labelledby': 'capture-title' };
    this.element = create('dialog', attributes, heading, this.form.element);
    this.form.element.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.runCapture(this.form.settings());
    });
    this.form.element.addEventListener('input', () => this.update());
    this.update();
    this.element.addEventListener('close', () => this.leave());
  }

  open(): void {
    if (this.element.open) return;
    this.work?.abort();
    this.wasPlaying ??= this.stage.playing;
    this.stage.pause();
    this.outcome.replaceChildren();
    this.form.measureWindow();
    this.update();
    this.element.showModal();
  }

  private leave(): void {
    // The close event fires asynchronously; the dialog may be open again by then.
    if (this.element.open) return;
    this.work?.abort();
    if (this.wasPlaying) this.stage.play();
    this.wasPlaying = undefined;
  }

  /** Files of other settings are dropped. */
  private update(): void {
    this.files.replaceChildren();
    this.compare.hidden = !isCompared(this.form.settings().format);
  }

  private runCapture(settings: CaptureSettings): Promise<void> {
    return this.run(strings.capture.working, async (task) => {
      this.save(settings.format, await capture(this.stage, settings, task));
    });
  }

  private runComparison(): Promise<void> {
    if (!this.form.element.reportValidity()) return Promise.resolve();
    const settings = this.form.settings();
    return this.run(strings.capture.comparing, async (task) => {
      const { compareFormats } = await import('./compare.ts');
      const found = await compareFormats(this.stage, settings, task);
      this.files.replaceChildren(sizesOf(found, (format, file) => this.save(format, file)));
      this.say(strings.capture.compared(found.filter(({ file }) => file).length));
    });
  }

  private async run(message: string, work: (task: Task) => Promise<void>): Promise<void> {
    const controller = (this.work = new AbortController());
    const { signal } = controller;
    const progress = new Progress(message, () => controller.abort());
    progress.element.classList.remove('card');
    this.outcome.replaceChildren(progress.element);
    this.files.replaceChildren();
    this.setLocked(true);
    try {
      await work({ signal, onProgress: (share) => progress.show(share) });
    } catch (error) {
      this.say(signal.aborted ? strings.capture.cancelled : strings.capture.failed((error as Error).message));
    } finally {
      this.setLocked(false);
    }
  }

  private setLocked(isLocked: boolean): void {
    this.form.isLocked = this.start.disabled = this.compare.disabled = isLocked;
  }

  private save(format: Format, file: Blob): void {
    const { scene } = this.stage.get();
    const name = `${String(scene)}-${this.stage.stats.time.toFixed(2)}s.${format === 'flipbook' ? 'flipbook.zip' : format}`;
    download(name, file);
    this.say(strings.capture.saved(name, file.size));
  }

  private say(message: string): void {
    this.outcome.replaceChildren(create('p', {}, message));
  }
}

/** A table of files with a button for each. */
function sizesOf(found: readonly Compared[], save: (format: Format, file: Blob) => void): HTMLTableElement {
  const { sizes, names, megabytes, save: label, saveAs } = strings.capture;
  const rows = found.map(({ format, file, note }) => {
    const name = create('th', { scope: 'row' }, names[format]);
    if (!file) return create('tr', {}, name, create('td', { colspan: 2 }, note ?? ''));
    const button = textButton('quiet', label, () => save(format, file));
    button.setAttribute('aria-label', saveAs(names[format]));
    const size = [megabytes(file.size), ...(note ? [note] : [])].join(', ');
    return create('tr', {}, name, create('td', {}, size), create('td', {}, button));
  });
  return create('table', {}, create('caption', {}, sizes), create('tbody', {}, ...rows));
}
