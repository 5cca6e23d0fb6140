import type { Stage } from '../../index.ts';
import { create, textButton, download } from '../ui/dom.ts';
import { Progress } from '../ui/progress.ts';
import { strings } from '../strings.ts';
import { SettingsForm } from './settingsForm.ts';
import type { CaptureSettings, Format } from './settings.ts';
import { type Task, openStudio, type Studio } from './studio.ts';

/** Dialog that selects what to capture, shows progress and allows cancelling. The smoke is paused meanwhile. */
export class CaptureDialog {
  readonly element: HTMLDialogElement;
  private readonly stage: Stage;
  private readonly form = new SettingsForm();
  private readonly outcome = create('div', { class: 'capture-outcome', role: 'status' });
  private readonly start = create('button', { type: 'submit', class: 'loud' }, strings.capture.start);
  private work: AbortController | undefined;
  private wasPlaying: boolean | undefined;

  constructor(stage: Stage) {
    this.stage = stage;
    const { title } = strings.capture;
    const close = textButton('quiet', strings.help.close, () => this.element.close());
    const buttons = create('div', { class: 'capture-buttons' }, this.start, close);
    this.form.element.append(this.outcome, buttons);
    const heading = create('h2', { id: 'capture-title' }, title);
    const attributes = { class: 'sheet card capture', 'aria-labelledby': 'capture-title' };
    this.element = create('dialog', attributes, heading, this.form.element);
    this.form.element.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.run(this.form.settings());
    });
    this.element.addEventListener('close', () => this.leave());
  }

  open(): void {
    if (this.element.open) return;
    this.work?.abort();
    this.wasPlaying ??= this.stage.playing;
    this.stage.pause();
    this.outcome.replaceChildren();
    this.form.measureWindow();
    this.element.showModal();
  }

  private leave(): void {
    // The close event fires asynchronously; the dialog may be open again by then.
    if (this.element.open) return;
    this.work?.abort();
    if (this.wasPlaying) this.stage.play();
    this.wasPlaying = undefined;
  }

  private async run(settings: CaptureSettings): Promise<void> {
    const work = (this.work = new AbortController());
    const progress = new Progress(strings.capture.working, () => work.abort());
    progress.element.classList.remove('card');
    this.outcome.replaceChildren(progress.element);
    this.form.isLocked = this.start.disabled = true;
    try {
      const onProgress = (share: number) => progress.show(share);
      const file = await capture(this.stage, settings, { signal: work.signal, onProgress });
      this.say(this.save(settings, file));
    } catch (error) {
      this.say(work.signal.aborted ? strings.capture.cancelled : strings.capture.failed((error as Error).message));
    } finally {
      this.form.isLocked = this.start.disabled = false;
    }
  }

  private save({ format }: CaptureSettings, file: Blob): string {
    const { scene } = this.stage.get();
    const name = `${String(scene)}-${this.stage.stats.time.toFixed(2)}s.${format === 'flipbook' ? 'flipbook.zip' : format}`;
    download(name, file);
    return strings.capture.saved(name, file.size);
  }

  private say(message: string): void {
    this.outcome.replaceChildren(create('p', {}, message));
  }
}

type Maker = (studio: Studio, settings: CaptureSettings, task: Task) => Promise<Blob>;

/** Encoders by format. Each module and its library are fetched on first use. */
const makers: Readonly<Record<Format, () => Promise<Maker>>> = {
  png: async () => (await import('./png.ts')).makePng,
  svg: async () => (await import('./svg.ts')).makeSvg,
  apng: async () => (await import('./clips/loops.ts')).makeLoop,
  webp: async () => (await import('./clips/loops.ts')).makeLoop,
  gif: async () => (await import('./clips/loops.ts')).makeLoop,
  webm: async () => (await import('./video.ts')).makeVideo,
  mp4: async () => (await import('./video.ts')).makeVideo,
  zip: async () => (await import('./pngSequence.ts')).makePngSequence,
  flipbook: async () => (await import('./flipbook.ts')).makeFlipbook,
};

/**
 * Captures what a stage shows, from the current time on, as a file. The stage is not modified.
 * @throws the reason of the task's signal when it is aborted; VideoError when the browser has no encoder for the format
 */
export async function capture(stage: Stage, settings: CaptureSettings, task: Task): Promise<Blob> {
  const make = await makers[settings.format]();
  const studio = await openStudio(stage, settings);
  try {
    task.signal.throwIfAborted();
    return await make(studio, settings, task);
  } finally {
    studio.stage.dispose();
  }
}
