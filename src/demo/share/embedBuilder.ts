import type { Stage } from '../../index.ts';
import type { Editor } from '../editor/editor.ts';
import { strings as page } from '../strings.ts';

// oxlint-disable-next-line import/no-unassigned-import -- its rules arrive with this module
import '../styles/embed.css';
import { create, textButton, download, copyText } from '../ui/dom.ts';
import { elementCode, FRAME, frameCode, heightOf, POSTER, type ElementScript, type EmbedOptions } from './embed.ts';
import { puffCall } from '../effects/code.ts';
import { fiberCode, ridingKeys, sceneOf, threeCode } from './sceneCode.ts';

/** Text of the embed builder, which is fetched with it. */
const strings = {
  what: 'Code for',
  kinds: {
    element: 'Custom element',
    frame: 'Iframe',
    three: 'three.js',
    fiber: 'React Three Fiber',
    puff: 'A puff by one call',
  },
  width: 'Width, px',
  full: 'Full width',
  ratio: 'Ratio',
  transparent: 'Transparent',
  interactive: 'Interactive',
  poster: 'Poster',
  alt: 'Description for screen readers',
  altHint: 'Empty for decoration',
  code: 'Code',
  copy: 'Copy code',
  copied: 'Code copied.',
  byHand: 'The browser blocked copying. Press Ctrl + C, or \u2318 C on a Mac.',
  leftOut: 'The code has only the smoke. The objects of this scene are not in it.',
  riding: 'Emitters and forces that move with an object stay where it is now.',
  download: 'Download poster',
  saved: (name: string) => `Saved as ${name}. Put it beside the page.`,
  failed: (reason: string) => `The poster could not be drawn. ${reason}`,
} as const;

const KINDS = ['element', 'frame', 'three', 'fiber', 'puff'] as const;
type Kind = (typeof KINDS)[number];
const RATIOS = ['16:9', '4:3', '1:1', '3:4', '9:16'];
/** The scene that is only smoke. */
const WITHOUT_OBJECTS = 'air';
/** Kinds of code with a scene of their own. */
const OF_THREE: readonly Kind[] = ['three', 'fiber'];
const WIDTHS = { min: 64, max: 3840 };
/** Options that a kind of code has; the others are hidden. */
const OPTIONS: Readonly<Record<Kind, readonly string[]>> = {
  element: ['size', 'transparent', 'interactive', 'poster', 'alt'],
  frame: ['size', 'transparent', 'interactive', 'alt'],
  three: ['size', 'transparent', 'interactive', 'alt'],
  fiber: ['size', 'transparent', 'interactive', 'alt'],
  puff: [],
};

/** Makes code for other pages from the current smoke. */
export class EmbedBuilder {
  private readonly editor: Editor;
  private readonly stage: Stage;
  private readonly kinds = KINDS.map((kind) => radio(kind));
  private readonly width = create('input', { type: 'number', ...WIDTHS, value: FRAME.width });
  private readonly full = checkbox();
  private readonly ratio = create('select', {}, ...RATIOS.map((ratio) => create('option', {}, ratio)));
  private readonly transparent = checkbox();
  private readonly interactive = checkbox();
  private readonly poster = checkbox();
  private readonly alt = create('input', { type: 'text', placeholder: strings.altHint });
  private readonly code = create('textarea', {
    readonly: true,
    rows: 7,
    'aria-label': strings.code,
    spellcheck: 'false',
  });
  private readonly note = create('p', { class: 'embed-note' });
  private readonly status = create('p', { class: 'share-status', role: 'status' });
  private readonly save = textButton('quiet', strings.download, () => void this.savePoster());
  private readonly groups: Readonly<Record<string, HTMLElement>>;
  private link = '';

  /** @param container that the builder is added to */
  constructor(container: HTMLElement, editor: Editor, stage: Stage) {
    this.editor = editor;
    this.stage = stage;
    const size = create('div', { class: 'embed-size' });
    size.append(
      labelled(strings.width, this.width),
      checked(strings.full, this.full),
      labelled(strings.ratio, this.ratio),
    );
    this.groups = {
      size,
      transparent: checked(strings.transparent, this.transparent),
      interactive: checked(strings.interactive, this.interactive),
      poster: checked(strings.poster, this.poster),
      alt: labelled(strings.alt, this.alt),
    };
    const { transparent, interactive, poster, alt } = this.groups;
    const kinds = create('fieldset', { class: 'embed-kinds' }, create('legend', {}, strings.what));
    this.kinds.forEach((input, index) => kinds.append(checked(strings.kinds[KINDS[index]], input)));
    const copy = textButton('loud', strings.copy, () => void this.copyCode());
    const form = create('form', { class: 'embed-options' }, kinds, size);
    form.append(create('div', { class: 'embed-flags' }, transparent, interactive, poster), alt);
    form.addEventListener('input', () => void this.write());
    form.addEventListener('submit', (event) => event.preventDefault());
    this.code.addEventListener('focus', () => this.code.select());
    const buttons = create('div', { class: 'share-buttons' }, copy, this.save, this.status);
    container.append(form, this.note, create('div', { class: 'share-snippet' }, this.code), buttons);
  }

  /** Makes the code for a share link. */
  show(link: string): void {
    this.link = link;
    this.notify('');
    void this.write();
  }

  private get kind(): Kind {
    return KINDS[this.kinds.findIndex((input) => input.checked)];
  }

  private get options(): EmbedOptions {
    const [across, up] = this.ratio.value.split(':').map(Number);
    const given = this.width.valueAsNumber || FRAME.width;
    return {
      width: this.full.checked ? undefined : Math.round(Math.min(Math.max(given, WIDTHS.min), WIDTHS.max)),
      ratio: [across, up],
      isTransparent: this.transparent.checked,
      isInteractive: this.interactive.checked,
      alt: this.alt.value.trim(),
      hasPoster: this.poster.checked,
    };
  }

  private async write(): Promise<void> {
    const { kind, link } = this;
    for (const [name, element] of Object.entries(this.groups)) element.hidden = !OPTIONS[kind].includes(name);
    this.width.disabled = this.full.checked;
    this.note.textContent = OF_THREE.includes(kind) ? leftOut(this.stage) : '';
    this.save.hidden = kind !== 'element' || !this.poster.checked;
    if (link === '') return;
    const code = await this.codeOf(kind, link);
    // A later choice may have been faster.
    if (kind === this.kind && link === this.link) this.code.value = code;
  }

  private async codeOf(kind: Kind, link: string): Promise<string> {
    const { options } = this;
    if (kind === 'element') return elementCode(link, options, publishedScript());
    if (kind === 'frame') return frameCode(link, options, page.title);
    if (kind === 'puff') return puffCall(this.editor.state);
    const scene = sceneOf(this.stage);
    return kind === 'three' ? threeCode(scene, options) : fiberCode(scene, options);
  }

  private async copyCode(): Promise<void> {
    if (await copyText(this.code.value)) return this.notify(strings.copied);
    this.code.focus();
    this.notify(strings.byHand);
  }

  /** Downloads the current picture in the size of the code, in two pixels per CSS pixel. */
  private async savePoster(): Promise<void> {
    const { width = FRAME.width, ratio, isTransparent } = this.options;
    try {
      const size = { width, height: heightOf(width, ratio), pixelRatio: 2 };
      const copy = await this.stage.copy(document.createElement('canvas'), size);
      try {
        copy.background = !isTransparent;
        download(POSTER, await copy.picture());
      } finally {
        copy.dispose();
      }
      this.notify(strings.saved(POSTER));
    } catch (error) {
      this.notify(strings.failed((error as Error).message));
    }
  }

  private notify(message: string): void {
    this.status.textContent = message;
  }
}

/** The script of the built site at its published URL; undefined on the development server. */
function publishedScript(): ElementScript | undefined {
  const path = import.meta.env.VITE_ELEMENT_SCRIPT as string | undefined;
  const integrity = import.meta.env.VITE_ELEMENT_INTEGRITY as string;
  return path ? { address: new URL(path, document.baseURI).href, integrity } : undefined;
}

/** Says what a scene of three.js does not have of the page's scene. */
function leftOut(stage: Stage): string {
  if (stage.get().scene === WITHOUT_OBJECTS) return '';
  return `${strings.leftOut} ${ridingKeys(stage).length > 0 ? strings.riding : ''}`.trim();
}

function radio(kind: Kind): HTMLInputElement {
  return create('input', { type: 'radio', name: 'embed-kind', value: kind, checked: kind === KINDS[0] });
}

function checkbox(): HTMLInputElement {
  return create('input', { type: 'checkbox' });
}

function labelled(name: string, control: HTMLElement): HTMLElement {
  return create('label', { class: 'embed-field' }, create('span', {}, name), control);
}

function checked(name: string, control: HTMLElement): HTMLElement {
  return create('label', { class: 'embed-check' }, control, create('span', {}, name));
}
