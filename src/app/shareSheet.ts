import { LONGEST_LINK } from '../preset/codec.ts';
import { linkTo } from './address.ts';
import { copyText } from './clipboard.ts';
import { create, iconButton, textButton } from './dom.ts';
import type { Editor } from './editor.ts';
import { createEmbed } from './embedCode.ts';
import type { SmokeFiles } from './files.ts';
import { icon } from './icons.ts';
import { linkToMoment } from './moment.ts';
import { createQr, MAX_QR_CHARACTERS } from './qr.ts';
import { createShareKind, type ShareKind } from './shareKind.ts';
import type { Stage } from '../stage/stage.ts';
import { strings } from './strings.ts';

const words = strings.share;

/** What people share: the look, or one very moment of it; as a link, a code, a file, or code for a page of theirs. */
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
  private readonly embed = createEmbed((text) => void this.copyText(text));
  private links: Record<ShareKind, string> = { look: '', moment: '' };

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
    this.element = create('dialog', attributes, heading, close, body, this.embed.element);
    this.send.hidden = !('share' in navigator);
  }

  /** Opens it on what is shown at this very moment. @param mesh name of a mesh that is shown, which no link can hold */
  async open(mesh?: string): Promise<void> {
    if (this.element.open) return;
    // A link of before, or none, must not be handed out while those of now are still written.
    this.links = { look: '', moment: '' };
    this.show(this.kind.chosen);
    this.element.showModal();
    const moment = linkToMoment(this.editor.state, this.stage);
    this.links = { look: await linkTo(this.editor), moment: await moment };
    this.show(this.kind.chosen);
    if (mesh !== undefined) this.notify(strings.ownShape.unshared(mesh));
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
    this.embed.show(sent || undefined);
    this.notify(isTooLong ? words.tooLong(link.length, LONGEST_LINK) : '');
    void this.showCode(link);
  }

  private async showCode(link: string): Promise<void> {
    this.code.hidden = link === '' || link.length > MAX_QR_CHARACTERS;
    if (this.code.hidden) return;
    const picture = await createQr(link, words.code);
    if (link === this.link) this.code.replaceChildren(picture, create('figcaption', {}, words.scan));
  }

  private async copyLink(): Promise<void> {
    if (await this.copyText(this.link)) return;
    this.field.focus();
    this.field.select();
  }

  private async copyText(text: string): Promise<boolean> {
    const isCopied = await copyText(text);
    this.notify(isCopied ? words.copied : words.byHand);
    return isCopied;
  }

  private async sendLink(): Promise<void> {
    try {
      await navigator.share({ title: strings.title, url: this.link });
    } catch (error) {
      // Whoever closes the sheet of the platform has changed their mind.
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
