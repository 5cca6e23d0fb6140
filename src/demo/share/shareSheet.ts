import type { Stage } from '../../index.ts';
import { LONGEST_LINK } from '../../internal.ts';
import { linkTo } from './address.ts';
import { create, iconButton, textButton, createSvg, copyText } from '../ui/dom.ts';
import type { Editor } from '../editor/editor.ts';
import type { SmokeFiles } from './files.ts';
import { icon } from '../ui/icons.ts';
import { linkToMoment } from './moment.ts';
import { createShareKind, type ShareKind } from './shareKind.ts';
import { strings } from '../strings.ts';
import type { EmbedBuilder } from './embedBuilder.ts';
import type { Bitmap2D } from 'lean-qr';

const words = strings.share;

/** Shares the look or an exact moment of the smoke, as a link, QR code, file or embed code. */
export class ShareSheet {
  readonly element: HTMLDialogElement;
  private readonly editor: Editor;
  private readonly stage: Stage;
  private readonly files: SmokeFiles;
  private readonly kind = createShareKind((kind) => this.show(kind));
  private readonly field = create('input', { type: 'text', readonly: true, 'aria-label': words.link });
  private readonly copy = textButton('loud', words.copy, () => void this.copyLink());
  private readonly send = textButton('quiet', words.send, () => void this.sendLink());
  private readonly status = create('p', { class: 'share-status', role: 'status' });
  private readonly code = create('figure', { class: 'share-code' });
  private readonly embed = create('details', { class: 'group share-embed' }, create('summary', {}, words.embed));
  private builder: EmbedBuilder | undefined;
  private links: Record<ShareKind, string> = { look: '', moment: '' };
  /** What links cannot contain, as sentences. */
  private missing = '';

  constructor(editor: Editor, stage: Stage, files: SmokeFiles) {
    this.editor = editor;
    this.stage = stage;
    this.files = files;
    const save = textButton('quiet', words.save, () => void this.saveFile());
    const heading = create('h2', { id: 'share-title' }, words.title);
    const close = iconButton('icon-button sheet-close', strings.help.close, icon('close'), () => this.element.close());
    const line = create('div', { class: 'share-line' }, this.field, this.copy);
    const buttons = create('div', { class: 'share-buttons' }, this.send, save, this.status);
    const main = create('div', { class: 'share-main' }, this.kind.element, line, buttons);
    const body = create('div', { class: 'share-body' }, main, this.code);
    const attributes = { class: 'sheet card share-sheet', 'aria-labelledby': 'share-title' };
    this.element = create('dialog', attributes, heading, close, body, this.embed);
    this.embed.addEventListener('toggle', () => void this.showEmbed());
    this.send.hidden = !('share' in navigator);
  }

  /**
   * Opens the dialog with the current smoke.
   * @param mesh name of the current mesh, which links cannot contain
   * @param model name of the model in the scene, which links cannot contain
   */
  async open(mesh?: string, model?: string): Promise<void> {
    if (this.element.open) return;
    this.missing = [
      ...(mesh === undefined ? [] : [strings.ownShape.unshared(mesh)]),
      ...(model === undefined ? [] : [strings.model.unshared(model)]),
    ].join(' ');
    // Clear the previous links until the new ones are encoded.
    this.links = { look: '', moment: '' };
    this.show(this.kind.chosen);
    this.element.showModal();
    const moment = linkToMoment(this.editor.state, this.stage);
    this.links = { look: await linkTo(this.editor), moment: await moment };
    this.show(this.kind.chosen);
    this.copy.focus();
  }

  private get link(): string {
    return this.links[this.kind.chosen];
  }

  private show(kind: ShareKind): void {
    const link = this.links[kind];
    const isTooLong = link.length > LONGEST_LINK;
    const sent = isTooLong ? '' : link;
    this.field.value = sent;
    this.field.disabled = this.copy.disabled = this.send.disabled = sent === '';
    this.embed.hidden = sent === '';
    this.builder?.show(sent);
    this.notify(isTooLong ? words.tooLong(link.length, LONGEST_LINK) : this.missing);
    void this.showCode(link);
  }

  private async showCode(link: string): Promise<void> {
    this.code.hidden = link === '' || link.length > MAX_QR_CHARACTERS;
    if (this.code.hidden) return;
    const picture = await createQr(link, words.code);
    if (link === this.link) this.code.replaceChildren(picture, create('figcaption', {}, words.scan));
  }

  /** Fetches the builder when its section is first open. */
  private async showEmbed(): Promise<void> {
    if (!this.embed.open) return;
    const { EmbedBuilder: Builder } = await import('./embedBuilder.ts');
    this.builder ??= new Builder(this.embed, this.editor, this.stage);
    this.builder.show(this.field.value);
  }

  private async copyLink(): Promise<void> {
    const isCopied = await copyText(this.link);
    this.notify(isCopied ? words.copied : words.byHand);
    if (isCopied) return;
    this.field.focus();
    this.field.select();
  }

  private async sendLink(): Promise<void> {
    try {
      await navigator.share({ title: strings.title, url: this.link });
    } catch (error) {
      // The user cancelled the share dialog of the platform.
      if ((error as Error).name !== 'AbortError') this.notify(words.notSent);
    }
  }

  private async saveFile(): Promise<void> {
    const name = await this.files.save(this.kind.chosen);
    this.notify(words.saved(name));
  }

  private notify(message: string): void {
    this.status.textContent = message;
  }
}

/** Width of the quiet zone around a QR code, in modules. */
const QUIET = 4;
/** Maximum number of bytes in a QR code. Many cameras cannot read denser codes. */
const MAX_QR_CHARACTERS = 1200;

/** A QR code for a link. The generator is fetched on first use. */
async function createQr(link: string, name: string): Promise<SVGSVGElement> {
  const { correction, generate } = await import('lean-qr');
  const code = generate(link, { minCorrectionLevel: correction.L });
  const size = code.size + 2 * QUIET;
  const picture = createSvg('svg', { viewBox: `0 0 ${size} ${size}`, class: 'qr', role: 'img', 'aria-label': name });
  picture.append(
    createSvg('rect', { width: size, height: size, fill: '#ffffff' }),
    createSvg('path', { d: modulesOf(code), fill: '#000000', 'shape-rendering': 'crispEdges' }),
  );
  return picture;
}

/** SVG path with a square for each dark module. */
function modulesOf(code: Bitmap2D): string {
  const squares: string[] = [];
  for (let y = 0; y < code.size; y++) {
    for (let x = 0; x < code.size; x++) {
      if (code.get(x, y)) squares.push(`M${x + QUIET} ${y + QUIET}h1v1h-1z`);
    }
  }
  return squares.join('');
}
