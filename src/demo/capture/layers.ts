import {
  hasPattern,
  inkOf,
  PixelReader,
  styleOf,
  type Arranger,
  type Color,
  type Rows,
  type Studio,
} from '../../internal.ts';
import type { Values } from '../../preset.ts';
import { isSame, linear } from './pixels.ts';

export const LAYERS = ['flats', 'shadow', 'ink', 'marks', 'surfaces', 'depth'] as const;
export type Layer = (typeof LAYERS)[number];

const NO_ROWS: Rows = { count: 0, whole: 0, place: new Float32Array(0), attributes: new Uint32Array(0) };

/**
 * Splits a frame into layers: flat colours without shadow and ink, shadow (the colours that it adds), ink, the marks of a
 * pattern if the style has one, surfaces (the picture without smoke), and depth, where near is white. Flats, shadow, ink and
 * marks composited in this order give the frame.
 */
export class LayerCamera {
  private readonly studio: Studio;
  private readonly reader: PixelReader;
  private hasSmoke = true;

  /** @param width, height of the studio's canvas, in pixels */
  constructor(studio: Studio, width: number, height: number) {
    this.studio = studio;
    this.reader = new PixelReader(width, height);
    studio.stage.running.picture.smoke.overrideFrame((input) =>
      this.hasSmoke ? input : { ...input, simulator: withoutRows(input.simulator) },
    );
  }

  /** The layers in the order of LAYERS. Until the next frame, the stage shows the last one. */
  async shoot(): Promise<(readonly [Layer, ImageData])[]> {
    const flats = this.flats();
    return [
      ['flats', flats],
      ['shadow', this.shadow(flats)],
      ['ink', this.ink()],
      ...(hasPattern(styleOf(this.style)) ? [['marks', this.marks()] as const] : []),
      ['surfaces', this.surfaces()],
      ['depth', await this.depth()],
    ];
  }

  /** Encodes a layer as a PNG. */
  encode(pixels: ImageData): Promise<Blob> {
    return this.reader.encode(pixels);
  }

  private get style(): Values {
    return this.studio.stage.shown;
  }

  private flats(): ImageData {
    return this.read({ 'style.outlines': 0, 'style.shadows': 0 });
  }

  private shadow(plain: ImageData): ImageData {
    const flats = new Uint32Array(plain.data.buffer);
    const shadowed = this.read({ 'style.outlines': 0 });
    const pixels = new Uint32Array(shadowed.data.buffer);
    pixels.forEach((pixel, at) => {
      if (isSame(pixel, flats[at])) pixels[at] = 0;
    });
    return shadowed;
  }

  private ink(): ImageData {
    const color = inkOf(styleOf(this.style));
    return this.coverage((code) => ({ 'style.inkColor': code, 'style.inkLight': 0 }), color);
  }

  private marks(): ImageData {
    const { patternCoverage, patternBackdrop, patternColor } = styleOf(this.style);
    const amounts = { 'style.patternCoverage': patternCoverage, 'style.patternBackdrop': patternBackdrop };
    return this.coverage((code) => ({ ...amounts, 'style.patternColor': code }), patternColor);
  }

  /**
   * Computes how much of each pixel has a colour, from the difference between a frame where it is white and one where it is
   * black.
   * @param valuesOf values with which a frame has the colour of a code
   * @param color of the layer
   */
  private coverage(valuesOf: (code: string) => Values, color: Color): ImageData {
    const black = this.read(valuesOf('#000000')).data;
    const white = this.read(valuesOf('#ffffff'));
    const { data } = white;
    for (let at = 0; at < data.length; at += 4) {
      const cover = linear(data[at]) - linear(black[at]);
      data.set(color, at);
      data[at + 3] = Math.round(data[at + 3] * Math.max(0, cover));
    }
    return white;
  }

  private surfaces(): ImageData {
    this.hasSmoke = false;
    const pixels = this.read({});
    this.hasSmoke = true;
    return pixels;
  }

  private async depth(): Promise<ImageData> {
    const { stage, canvas } = this.studio;
    stage.view = 'depth';
    await stage.complete();
    const pixels = this.reader.read(canvas);
    stage.view = undefined;
    return pixels;
  }

  private read(values: Values): ImageData {
    const { stage, canvas } = this.studio;
    // Only their own layer has marks.
    stage.running.showWith({ 'style.patternCoverage': 0, 'style.patternBackdrop': 0, ...values });
    return this.reader.read(canvas);
  }
}

/** Keeps the bounds and the lamps, so that shadow and light of the surfaces stay the same. */
function withoutRows(simulator: Arranger): Arranger {
  return {
    arrange: (view) => ({ ...simulator.arrange(view), rows: NO_ROWS, grid: undefined }),
    glow: (blend, colors) => simulator.glow!(blend, colors),
    moves: () => new Float32Array(),
  };
}
