import type { Stage } from '../../index.ts';
import { FileError } from '../../preset.ts';
import type { Editor } from '../editor/editor.ts';
// oxlint-disable-next-line import/no-unassigned-import -- its rules arrive with this module
import '../styles/palette.css';
import { create, createSvg, textButton, uniqueId } from '../ui/dom.ts';
import type { Notices } from '../ui/notices.ts';
import { labOf } from './color.ts';
import { changesOf, looksOf, type Look } from './looks.ts';
import { MAX_BYTES, readPalette } from './paletteFile.ts';
import { colorsOfPicture, type Found } from './picture.ts';
import { words } from './words.ts';

/** What looks are applied to. */
export interface PaletteParts {
  readonly editor: Editor;
  readonly stage: Stage;
  readonly notices: Notices;
}

/**
 * The colours of a palette, or of a picture.
 * @throws FileError, ShapeError with what is wrong with the file; the reason of the signal when it is aborted
 */
export async function colorsOfFile(file: File, signal: AbortSignal): Promise<Found[]> {
  if (isPicture(file)) {
    const found = await colorsOfPicture(file, signal);
    if (found.length === 0) throw new FileError(words.faults.transparent);
    if (found.length === 1) throw new FileError(words.faults.oneColor(found[0].color));
    return found;
  }
  // A byte more than the limit shows that the file is too large.
  const colors = readPalette(new Uint8Array(await file.slice(0, MAX_BYTES + 1).arrayBuffer()));
  return colors.map((color) => ({ color, share: 1 / colors.length }));
}

function isPicture({ name, type }: File): boolean {
  return type.startsWith('image/') || /\.(png|svg|jpe?g|webp|gif|avif|bmp)$/i.test(name);
}

/** Pixels of a preview in CSS pixels. */
const [WIDTH, HEIGHT] = [264, 176];
const MOST_PIXEL_RATIO = 2;
/** Visible fraction of the frame, from its centre, so that the preview shows the smoke and not the room. */
const SHOWN = 0.72;

/** A proposal in the dialog. */
interface Card {
  readonly look: Look;
  readonly button: HTMLButtonElement;
  /** Shows the smoke of the page in the look, once it is drawn. */
  readonly canvas: HTMLCanvasElement;
}

/**
 * Dialog with the proposed looks beside each other. Each shows a drawing until the smoke of the page is drawn in its colours.
 * Choosing one is one change. Closing the dialog changes nothing.
 */
export class LookDialog {
  private readonly element: HTMLDialogElement;
  private readonly parts: PaletteParts;
  private readonly file: string;
  private readonly cards: readonly Card[];
  private readonly status = create('p', { class: 'looks-status', role: 'status' });
  private isClosed = false;

  /** @param file name of the file that the colours are from */
  constructor(found: readonly Found[], file: string, parts: PaletteParts) {
    this.parts = parts;
    this.file = file;
    this.cards = looksOf(found).map((look) => this.createCard(look));
    const heading = create('h2', { id: 'looks-title' }, words.title);
    const cancel = textButton('quiet', words.cancel, () => this.element.close());
    const cards = create('div', { class: 'looks-cards' }, ...this.cards.map(({ button }) => button));
    const foot = create('div', { class: 'looks-foot' }, this.status, cancel);
    const attributes = {
      class: 'sheet card looks',
      'aria-labelledby': 'looks-title',
      'aria-describedby': 'looks-text',
    };
    const text = create('p', { id: 'looks-text', class: 'looks-text' }, words.text);
    this.element = create('dialog', attributes, heading, createSource(found, file), text, cards, foot);
  }

  /**
   * Opens the dialog. The smoke pauses meanwhile.
   * @param container its parent
   * @param signal closes it
   */
  show(container: HTMLElement, signal: AbortSignal): void {
    const { stage } = this.parts;
    const wasPlaying = stage.playing;
    stage.pause();
    this.element.addEventListener('close', () => {
      this.isClosed = true;
      this.element.remove();
      if (wasPlaying) stage.play();
    });
    signal.addEventListener('abort', () => this.element.close());
    container.append(this.element);
    this.element.showModal();
    void this.drawSmoke();
  }

  private createCard(look: Look): Card {
    const [label, text] = words.looks[look.kind];
    const canvas = create('canvas', { class: 'look-smoke', hidden: true });
    const picture = create('span', { class: 'look-picture', 'aria-hidden': 'true' });
    picture.append(drawingOf(look), canvas);
    const named = create('span', { class: 'look-words' }, create('strong', {}, label), create('small', {}, text));
    named.append(createColors(look));
    const button = create('button', { type: 'button', class: 'look' }, picture, named);
    button.addEventListener('click', () => this.take(look));
    return { look, button, canvas };
  }

  private take(look: Look): void {
    const { editor, notices } = this.parts;
    this.element.close();
    editor.changeAll(changesOf(look, editor.state.values));
    notices.mention(words.taken(words.looks[look.kind][0], this.file));
  }

  /** Draws a copy of the page's smoke in each look. Without the copy, the drawings stay. */
  private async drawSmoke(): Promise<void> {
    const { stage, editor } = this.parts;
    this.status.textContent = words.drawing;
    try {
      await editor.delivered();
      const copy = await stage.copy(document.createElement('canvas'), { width: 1, height: 1, historyBytes: 0 });
      try {
        copy.resize(WIDTH / SHOWN, HEIGHT / SHOWN, Math.min(devicePixelRatio, MOST_PIXEL_RATIO));
        for (const card of this.cards) {
          if (this.isClosed) return;
          copy.set(changesOf(card.look, editor.state.values));
          await paint(card.canvas, await copy.picture());
        }
      } finally {
        copy.dispose();
      }
    } catch {
      // The drawings show the colours, too.
    } finally {
      this.status.textContent = '';
    }
  }
}

async function paint(canvas: HTMLCanvasElement, picture: Blob): Promise<void> {
  const bitmap = await createImageBitmap(picture);
  const [width, height] = [bitmap.width, bitmap.height].map((length) => Math.round(SHOWN * length));
  [canvas.width, canvas.height] = [width, height];
  canvas.getContext('2d')!.drawImage(bitmap, (width - bitmap.width) / 2, (height - bitmap.height) / 2);
  bitmap.close();
  canvas.hidden = false;
}

/** Most stripes of the bar with the colours of the file. */
const MOST_STRIPES = 64;

/** The colours of the file from dark to light; of many, some. */
function createSource(found: readonly Found[], file: string): HTMLElement {
  const label = words.source(file, found.length);
  const lights = new Map(found.map(({ color }) => [color, labOf(color).l]));
  const sorted = [...lights.keys()].sort((a, b) => lights.get(a)! - lights.get(b)!);
  const every = Math.max(1, sorted.length / MOST_STRIPES);
  const colors = sorted.filter((_, at) => Math.floor(at / every) > Math.floor((at - 1) / every));
  return create('figure', { class: 'looks-source' }, barOf(colors), create('figcaption', {}, label));
}

/** Equal stripes of colours. */
function barOf(colors: readonly string[]): SVGSVGElement {
  const bar = createSvg('svg', {
    viewBox: `0 0 ${colors.length} 1`,
    preserveAspectRatio: 'none',
    'aria-hidden': 'true',
  });
  // Overlaps the next one, so that nothing shows between them.
  colors.forEach((fill, x) => bar.append(createSvg('rect', { x, y: 0, width: colors.length - x, height: 1, fill })));
  return bar;
}

/** The tones of a look, then its ink and its backdrop. */
function createColors({ tones, ink, backdrop }: Look): HTMLElement {
  const spots = [ink, ...new Set(backdrop)].map((fill) => {
    const spot = createSvg('svg', { class: 'look-spot', viewBox: '0 0 2 2', 'aria-hidden': 'true' });
    spot.append(createSvg('circle', { cx: 1, cy: 1, r: 1, fill }));
    return spot;
  });
  return create('span', { class: 'look-colors' }, barOf(tones), ...spots);
}

/** Centres and radii of the puffs of a drawing, the farthest first. */
const PUFFS = [
  [98, 104, 30],
  [168, 106, 28],
  [132, 76, 40],
  [110, 122, 24],
  [150, 126, 26],
] as const;
const LINE = 2.2;

/** A cloud in the colours of a look. */
function drawingOf({ tones, ink, backdrop }: Look): SVGSVGElement {
  const drawing = createSvg('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, 'aria-hidden': 'true' });
  const sky = createSvg('linearGradient', { id: uniqueId(), x1: 0, x2: 0, y1: 1, y2: 0 });
  sky.append(...backdrop.map((color, offset) => createSvg('stop', { offset, 'stop-color': color })));
  drawing.append(sky, createSvg('rect', { width: WIDTH, height: HEIGHT, fill: `url(#${sky.id})` }));
  for (const [cx, cy, r] of PUFFS) {
    drawing.append(createSvg('circle', { cx, cy, r: r + LINE, fill: ink }));
    tones.forEach((fill, tone) => {
      const size = r * (1 - (0.72 * tone) / tones.length);
      // Circles that touch on the side of the light.
      const shift = (r - size) * 0.65;
      drawing.append(createSvg('circle', { cx: cx - shift, cy: cy - shift, r: size, fill }));
    });
  }
  return drawing;
}
