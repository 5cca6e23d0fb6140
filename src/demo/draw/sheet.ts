import { isAccepted, MAX_DRAWINGS, readDrawings } from '../../internal.ts';
import { findParameter } from '../../preset.ts';
import type { Editor } from '../editor/editor.ts';
import { strings } from '../strings.ts';
import { create, iconButton, textButton } from '../ui/dom.ts';
import { icon, type IconName } from '../ui/icons.ts';
import type { Notices } from '../ui/notices.ts';
import { Easel, type Draft } from './easel.ts';
import { PICTURE_TYPES, sketchesOfText, sketchOfFile } from './import.ts';
import { COLORS, coverageOf, emptySketch, sketchOf, type Brush, type Sketch } from './sketch.ts';
import { traceSketch, type Trace } from './trace.ts';

const words = strings.drawing;
const KEY = 'puff.drawing';
/** Milliseconds between two updates of the smoke during a stroke. */
const PERIOD_MS = 150;
const [MIN_WIDTH, MAX_WIDTH, FIRST_WIDTH] = [3, 80, 30];
const TOOLS = ['pen', 'eraser', 'fill', 'fold'] as const satisfies readonly IconName[];

/** All variations. */
interface Sheaf {
  readonly sketches: readonly Sketch[];
  readonly current: number;
}

/**
 * The sheet for drawing puffs. The smoke shows each stroke at once; the whole session is one undo step of the page, and
 * each stroke is one of the sheet.
 */
export class DrawSheet implements Draft {
  readonly element: HTMLDialogElement;
  brush: Brush = { tool: 'pen', width: FIRST_WIDTH, ink: 1, isMirrored: false };
  private readonly editor: Editor;
  private readonly notices: Notices;
  private readonly easel: Easel;
  private readonly traces = new WeakMap<Sketch, Trace>();
  private readonly status = create('p', { class: 'draw-status', role: 'status' });
  private readonly tools: HTMLElement;
  private readonly swatches: readonly HTMLInputElement[];
  private readonly color = create('input', { type: 'color', 'aria-label': words.color });
  private readonly tabs = create('div', { class: 'draw-tabs' });
  private readonly undoButton = iconButton('icon-button', strings.panel.undo, icon('undo'), () => this.undo());
  private readonly redoButton = iconButton('icon-button', strings.panel.redo, icon('redo'), () => this.redo());
  private readonly onClose: () => void;
  private sheaf: Sheaf = { sketches: [emptySketch()], current: 0 };
  private past: Sheaf[] = [];
  private future: Sheaf[] = [];
  private isEditing = false;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** The text that the page had before, and the one that it has from here. */
  private before = '';
  private written: string | undefined;
  private preset: string | undefined;

  /** @param onClose called when the sheet has closed */
  constructor(editor: Editor, notices: Notices, onClose: () => void) {
    this.editor = editor;
    this.notices = notices;
    this.onClose = onClose;
    this.easel = new Easel(this);
    this.tools = this.createTools();
    this.swatches = COLORS.map((_, at) => this.createSwatch(at));
    this.color.addEventListener('input', () => this.recolor(false));
    this.color.addEventListener('change', () => this.recolor(true));
    const colors = create(
      'fieldset',
      { class: 'draw-colors' },
      create('legend', { class: 'read-aloud' }, words.colors),
    );
    colors.append(...this.swatches, this.color);
    const body = create('div', { class: 'draw-body' }, this.tools, this.easel.canvas, this.easel.help, this.status);
    body.append(colors, this.createWidth(), this.tabs, this.createImports());
    const attributes = { class: 'draw-sheet card', 'aria-labelledby': 'draw-title' };
    this.element = create('dialog', attributes, this.createHead(), body);
    this.element.addEventListener('keydown', (event) => this.type(event));
    this.element.addEventListener('keyup', (event) => event.stopPropagation());
    editor.listen(({ preset, values }) => {
      const text = values[KEY] ?? '';
      if (!this.element.open || text === this.written) return;
      // Drawings are tried in several scenes: another preset keeps them.
      if (preset !== this.preset) queueMicrotask(() => this.publish());
      else this.load(text);
      this.preset = preset;
    });
  }

  /** Opens the sheet with the drawings of the page. */
  open(): void {
    if (this.element.open) return;
    this.before = this.editor.state.values[KEY] ?? '';
    this.preset = this.editor.state.preset;
    this.load(this.before);
    this.element.show();
    this.easel.canvas.focus();
  }

  /** Closes the sheet and keeps the drawings. */
  close(): void {
    if (!this.element.open) return;
    this.publish();
    this.element.close();
    this.editor.settle();
    this.onClose();
  }

  /** Puts a picture on the sheet. */
  async import(file: File): Promise<void> {
    try {
      this.edit(await sketchOfFile(file), true);
    } catch (error) {
      this.notices.notify((error as Error).message);
    }
  }

  get current(): number {
    return this.sheaf.current;
  }

  get sketch(): Sketch {
    return this.sheaf.sketches[this.sheaf.current];
  }

  private load(text: string): void {
    const isValid = text !== '' && isAccepted(findParameter(KEY)!, text);
    const sketches = isValid ? readDrawings(text).map(sketchOf) : [emptySketch()];
    // Unchanged drawings keep their text.
    if (isValid) text.split(';').forEach((each, at) => this.traces.set(sketches[at], { text: each, isRough: false }));
    this.written = text;
    this.past = [];
    this.future = [];
    this.sheaf = { sketches, current: Math.min(this.sheaf.current, sketches.length - 1) };
    this.show();
  }

  private cancel(): void {
    clearTimeout(this.timer);
    this.load(this.before);
    this.editor.change(KEY, this.before, KEY);
    this.close();
  }

  edit(sketch: Sketch, isOver: boolean): void {
    const { sketches, current } = this.sheaf;
    this.replace({ sketches: sketches.with(current, sketch), current }, isOver);
  }

  private replace(sheaf: Sheaf, isOver = true): void {
    if (!this.isEditing) {
      this.past.push(this.sheaf);
      this.future = [];
    }
    this.isEditing = !isOver;
    this.sheaf = sheaf;
    if (isOver) this.update();
    else {
      this.easel.show();
      this.timer ??= setTimeout(() => this.publish(), PERIOD_MS);
    }
  }

  private undo(): void {
    this.go(this.past, this.future);
  }

  private redo(): void {
    this.go(this.future, this.past);
  }

  private go(from: Sheaf[], to: Sheaf[]): void {
    const sheaf = from.pop();
    if (!sheaf) return;
    to.push(this.sheaf);
    this.sheaf = sheaf;
    this.update();
  }

  private update(): void {
    this.publish();
    this.show();
  }

  /** Sets the parameter. Empty sketches are left out. */
  private publish(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    const texts = this.sheaf.sketches.map((sketch) => this.traceOf(sketch).text);
    this.written = texts.filter((text) => text !== '').join(';');
    if (this.written !== this.editor.state.values[KEY]) this.editor.change(KEY, this.written, KEY);
  }

  private traceOf(sketch: Sketch): Trace {
    const trace = this.traces.get(sketch) ?? traceSketch(sketch);
    this.traces.set(sketch, trace);
    return trace;
  }

  private show(): void {
    const { sketches, current } = this.sheaf;
    const { brush, sketch } = this;
    this.easel.show();
    this.undoButton.disabled = this.past.length === 0;
    this.redoButton.disabled = this.future.length === 0;
    this.swatches.forEach((swatch, at) => {
      swatch.checked = at === brush.ink - 1;
      swatch.style.setProperty('--swatch', sketch.colors[at]);
      swatch.ariaLabel = words.swatch(at + 1, sketch.colors[at]);
    });
    this.color.value = sketch.colors[brush.ink - 1];
    this.showTabs();
    const { isRough } = this.traceOf(sketch);
    const said = words.status(current + 1, sketches.length, words.tools[brush.tool], coverageOf(sketch));
    this.status.textContent = isRough ? `${said} ${words.rough}` : said;
  }

  private showTabs(): void {
    const { sketches, current } = this.sheaf;
    const choose = (at: number): void => {
      this.sheaf = { sketches, current: at };
      this.show();
      this.tabs.querySelectorAll('button')[at].focus();
    };
    const puffs = sketches.map((_, at) => {
      const button = textButton('quiet', String(at + 1), () => choose(at));
      button.ariaLabel = words.puff(at + 1);
      button.ariaPressed = String(at === current);
      return button;
    });
    const insert = (sketch: Sketch): void =>
      this.replace({ sketches: [...sketches, sketch], current: sketches.length });
    const add = iconButton('icon-button', words.add, icon('add'), () => insert(emptySketch()));
    const copy = iconButton('icon-button', words.duplicate, icon('copy'), () => insert({ ...this.sketch }));
    const remove = iconButton('icon-button', words.removePuff, icon('remove'), () => {
      const rest = sketches.length > 1 ? sketches.toSpliced(current, 1) : [emptySketch()];
      this.replace({ sketches: rest, current: Math.min(current, rest.length - 1) });
    });
    add.disabled = copy.disabled = sketches.length === MAX_DRAWINGS;
    const buttons = [...puffs, add, copy, remove];
    // The focus stays on a button that acts on all variations.
    const focused = [...this.tabs.children].indexOf(document.activeElement!) - this.tabs.childElementCount;
    this.tabs.replaceChildren(...buttons);
    if (focused < 0 && focused >= -3) buttons.at(focused)!.focus();
  }

  private type(event: KeyboardEvent): void {
    // The page's shortcuts would act, too.
    event.stopPropagation();
    const key = event.key.toLowerCase();
    if (event.key === 'Escape') this.close();
    else if ((event.ctrlKey || event.metaKey) && (key === 'z' || key === 'y')) {
      event.preventDefault();
      if (key === 'y' || event.shiftKey) this.redo();
      else this.undo();
    }
  }

  private createHead(): HTMLElement {
    const heading = create('h2', { id: 'draw-title' }, words.title);
    const cancel = textButton('quiet', words.cancel, () => this.cancel());
    const done = textButton('loud', words.done, () => this.close());
    return create('header', { class: 'panel-head' }, heading, this.undoButton, this.redoButton, cancel, done);
  }

  /** The tools and the toggle, which the arrow keys reach from each other. */
  private createTools(): HTMLElement {
    const tools = TOOLS.map((tool) => iconButton('icon-button', words.tools[tool], icon(tool), () => choose(tool)));
    const choose = (tool: Brush['tool']): void => {
      this.brush = { ...this.brush, tool };
      tools.forEach((button, at) => (button.ariaPressed = String(TOOLS[at] === tool)));
      this.show();
    };
    tools.forEach((button, at) => (button.ariaPressed = String(at === 0)));
    const mirror = iconButton('icon-button', words.mirror, icon('mirror'), () => {
      this.brush = { ...this.brush, isMirrored: !this.brush.isMirrored };
      mirror.ariaPressed = String(this.brush.isMirrored);
      this.show();
    });
    mirror.ariaPressed = 'false';
    const clear = iconButton('icon-button', words.clear, icon('remove'), () =>
      this.edit({ ...emptySketch(), colors: this.sketch.colors }, true),
    );
    const bar = create('div', { class: 'draw-tools', role: 'toolbar', 'aria-label': words.toolbar });
    const buttons = [...tools, mirror, clear];
    bar.append(...buttons);
    buttons.forEach((button, at) => (button.tabIndex = at === 0 ? 0 : -1));
    bar.addEventListener('focusin', ({ target }) => {
      for (const button of buttons) button.tabIndex = button === target ? 0 : -1;
    });
    bar.addEventListener('keydown', ({ key }) => {
      const way = key === 'ArrowRight' ? 1 : key === 'ArrowLeft' ? -1 : 0;
      const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
      if (way !== 0) buttons.at((at + way) % buttons.length)!.focus();
    });
    return bar;
  }

  private createSwatch(at: number): HTMLInputElement {
    const swatch = create('input', { type: 'radio', name: 'draw-color', class: 'draw-swatch' });
    swatch.addEventListener('change', () => {
      this.brush = { ...this.brush, ink: at + 1 };
      this.show();
    });
    return swatch;
  }

  private recolor(isOver: boolean): void {
    const colors = this.sketch.colors.with(this.brush.ink - 1, this.color.value);
    this.swatches[this.brush.ink - 1].style.setProperty('--swatch', this.color.value);
    this.edit({ ...this.sketch, colors }, isOver);
  }

  private createWidth(): HTMLElement {
    const range = create('input', { type: 'range', min: MIN_WIDTH, max: MAX_WIDTH });
    const show = (): void =>
      range.style.setProperty('--filled', String((this.brush.width - MIN_WIDTH) / (MAX_WIDTH - MIN_WIDTH)));
    range.valueAsNumber = FIRST_WIDTH;
    range.addEventListener('input', () => {
      this.brush = { ...this.brush, width: range.valueAsNumber };
      show();
      this.easel.show();
    });
    show();
    return create('label', { class: 'draw-width' }, words.width, range);
  }

  private createImports(): HTMLElement {
    const chooser = create('input', { type: 'file', accept: PICTURE_TYPES, hidden: true, 'aria-label': words.import });
    chooser.addEventListener('change', () => {
      const file = chooser.files?.[0];
      if (file) void this.import(file);
      chooser.value = '';
    });
    const field = create('input', {
      type: 'text',
      maxlength: 40,
      size: 5,
      'aria-label': words.text,
      placeholder: 'POW',
    });
    const letters = create('button', { class: 'quiet' }, words.letters);
    const form = create('form', { class: 'draw-imports' }, field, letters);
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.writeLetters(field.value);
    });
    form.append(
      textButton('quiet', words.import, () => chooser.click()),
      chooser,
    );
    return form;
  }

  private writeLetters(text: string): void {
    try {
      const sketches = sketchesOfText(text, this.brush.ink);
      if (sketches.length === 0) return;
      this.replace({ sketches: sketches.map((each) => ({ ...each, colors: this.sketch.colors })), current: 0 });
      if (Array.from(text.replaceAll(/\s/g, '')).length > MAX_DRAWINGS)
        this.notices.mention(words.fourLetters(MAX_DRAWINGS));
    } catch (error) {
      this.notices.notify((error as Error).message);
    }
  }
}
