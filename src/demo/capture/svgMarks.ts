import { formatColor, hasPattern, type Style } from '../../internal.ts';
import type { Labels } from './labels.ts';
import { linear } from './pixels.ts';

/** Bands of equal amount, each with a pattern of its own. */
export const BANDS = 8;
/** Side of the repeated square of grain, in distances between marks. */
const GRAINS = 8;

/** Values without marks. Tones are chosen in the same way as with them. */
export const WITHOUT_MARKS = { 'style.patternCoverage': 0, 'style.patternBackdrop': 0 } as const;

/**
 * A style whose pictures have the amount of marks in place of marks: the difference between a picture with white marks and one
 * with black marks.
 */
export function styleOfAmounts(style: Style): Style {
  // A kind that is not offered: the shader writes the amount itself.
  return { ...style, pattern: 'amount' as Style['pattern'], outlines: false };
}

/** Bands of amounts, 1 to {@link BANDS}, from pictures by {@link styleOfAmounts}; 0 where there are no marks. */
export function bandsOf(white: ImageData, black: ImageData, style: Style): Labels {
  const most = Math.max(style.patternCoverage, style.patternBackdrop);
  const { width, height } = white;
  const of = Uint8Array.from({ length: width * height }, (_, pixel) => {
    const amount = linear(white.data[4 * pixel]) - linear(black.data[4 * pixel]);
    return Math.min(BANDS, Math.round((BANDS * amount) / most));
  });
  return { width, height, of, colors: Array.from({ length: BANDS + 1 }, (_, band) => band) };
}

/**
 * The definition of a band's pattern, in pixels of the picture.
 * @param pixelRatio pixels of the picture for each CSS pixel
 */
export function patternOf(band: number, style: Style, pixelRatio: number): string {
  const { pattern, patternAngle, patternColor, patternCoverage, patternBackdrop, patternSize } = style;
  const amount = (band / BANDS) * Math.max(patternCoverage, patternBackdrop);
  const size = patternSize * pixelRatio;
  const side = pattern === 'grain' ? GRAINS * size : size;
  const line = (share: number, attribute: 'width' | 'height') => {
    const other = attribute === 'width' ? 'height' : 'width';
    return share > 0 ? `<rect ${attribute}="${short(share * size)}" ${other}="${short(size)}"/>` : '';
  };
  const marks = {
    none: () => '',
    dots: () => circle(size / 2, size / 2, size * Math.sqrt(amount / Math.PI)),
    lines: () => line(amount, 'height'),
    crosshatch: () => line(crossed(amount), 'height') + line(crossed(2 * amount - patternCoverage), 'width'),
    grain: () => grains(amount, size),
  }[pattern]();
  const place = `width="${short(side)}" height="${short(side)}" patternTransform="rotate(${short(-patternAngle)})"`;
  return `<pattern id="marks-${band}" patternUnits="userSpaceOnUse" ${place} fill="${formatColor(patternColor)}">${marks}</pattern>`;
}

/** Whether the values of a style have marks. */
export function hasMarks(style: Style): boolean {
  return hasPattern(style) && Math.max(style.patternCoverage, style.patternBackdrop) > 0;
}

/** The share of each of two lines that cross and together cover an amount. */
function crossed(amount: number): number {
  return 1 - Math.sqrt(1 - Math.max(0, amount));
}

/** Circles of different sizes beside the points of a lattice, which cover a share of their square. */
function grains(amount: number, size: number): string {
  let state = 1;
  const random = () => (state = (state * 48_271) % 0x7fff_ffff) / 0x7fff_ffff;
  return Array.from({ length: GRAINS * GRAINS }, (_, index) => {
    const [x, y] = [index % GRAINS, Math.floor(index / GRAINS)].map((cell) => (cell + 0.3 + 0.4 * random()) * size);
    return circle(x, y, size * Math.sqrt((2 * random() * amount) / Math.PI));
  }).join('');
}

function circle(x: number, y: number, radius: number): string {
  return `<circle cx="${short(x)}" cy="${short(y)}" r="${short(radius)}"/>`;
}

function short(value: number): string {
  return String(Number(value.toFixed(2)));
}
