import {
  inkOf,
  PixelReader,
  readRamp,
  simplifyArc,
  styleOf,
  type Point,
  type RampStop,
  type Studio,
  type Style,
} from '../../internal.ts';
import { labelColors, type Labels } from './labels.ts';
import { pixelSize, type CaptureSettings } from './settings.ts';
import { isSame, NOISE } from './pixels.ts';
import { bandsOf, hasMarks, patternOf, styleOfAmounts, WITHOUT_MARKS } from './svgMarks.ts';

/** Maximum deviation of outlines in pixels, too small to be visible. */
const TOLERANCE = 0.6;
const STOPS = 9;

/**
 * Encodes a frame as SVG: backdrop, flats with their shadow, the marks of a pattern, and ink, each a named group with one path
 * for each colour, or for each amount of marks. Flats and marks continue beneath ink. Gradients become discrete steps.
 */
export async function makeSvg(studio: Studio, settings: CaptureSettings): Promise<Blob> {
  const [width, height] = pixelSize(settings);
  const { stage, canvas, draw } = studio;
  const reader = new PixelReader(width, height);
  const values = stage.shown;
  const style = styleOf(values);
  const inkColor = pixelOf(inkOf(style));
  const ramp = readRamp(values['style.backdrop'] ?? '') ?? [];
  const marks = hasMarks(style) ? marksIn(studio, reader, style, width / settings.width) : undefined;
  if (marks) stage.set(WITHOUT_MARKS);
  draw();
  const whole = reader.read(canvas);
  if (settings.hasBackground) stage.background = false;
  const cut = settings.hasBackground ? reader.read(canvas) : whole;
  stage.set({ 'style.outlines': 0 });
  const flats = labelColors(reader.read(canvas));
  const ink = labelColors(cut);
  const groups = [
    ...(settings.hasBackground ? [backdrop(ramp, whole, cut)] : []),
    group('flats', flats, flats.colors.slice(1)),
    ...(marks ? [marks] : []),
    group(
      'ink',
      ink,
      ink.colors.filter((color) => isSame(color, inkColor)),
    ),
  ];
  const size = `width="${settings.width}" height="${settings.height}" viewBox="0 0 ${width} ${height}"`;
  const text = `<svg xmlns="http://www.w3.org/2000/svg" ${size}>\n${groups.join('\n')}\n</svg>\n`;
  return new Blob([text], { type: 'image/svg+xml' });
}

/** A group of paths that patterns fill, one for each amount of marks. */
function marksIn({ stage, canvas, draw }: Studio, reader: PixelReader, style: Style, pixelRatio: number): string {
  const { smoke } = stage.running.picture;
  smoke.overrideFrame((input) => ({ ...input, style: styleOfAmounts(input.style) }));
  draw();
  const [white, black] = ['#ffffff', '#000000'].map((code) => {
    stage.set({ 'style.patternColor': code });
    return reader.read(canvas);
  });
  smoke.overrideFrame((input) => input);
  const labels = bandsOf(white, black, style);
  const bands = [...new Set(labels.of)].filter((band) => band > 0).toSorted((one, other) => one - other);
  const patterns = bands.map((band) => patternOf(band, style, pixelRatio));
  const paths = bands.map((band) => {
    const shape = traceRegion(labels, band, TOLERANCE).map(pathOf).join('');
    return shape && `<path fill="url(#marks-${band})" d="${shape}"/>`;
  });
  return ['<g id="marks" fill-rule="evenodd">', ...patterns, ...paths.filter(Boolean), '</g>'].join('\n');
}

/** A group of paths, one for each colour. The stroke closes gaps that rounding leaves. */
function group(name: string, labels: Labels, colors: readonly number[]): string {
  const paths = colors.map((color) => {
    const outlines = traceRegion(labels, labels.colors.indexOf(color), TOLERANCE);
    const shape = outlines.map(pathOf).join('');
    return shape && `<path fill="${hexOf(color)}" stroke="${hexOf(color)}" d="${shape}"/>`;
  });
  return `<g id="${name}" fill-rule="evenodd" stroke-width=".7">\n${paths.filter(Boolean).join('\n')}\n</g>`;
}

/** Path data of a closed outline, in relative commands at half-pixel precision to keep it short. */
function pathOf(outline: readonly Point[]): string {
  let [x, y] = outline[0];
  const steps = outline.slice(1).map(([toX, toY]) => {
    const step = [toX - x, toY - y].map(short);
    [x, y] = [toX, toY];
    return step[1].startsWith('-') ? step.join('') : step.join(' ');
  });
  return `M${short(outline[0][0])} ${short(outline[0][1])}l${steps.join(' ')}z`.replaceAll(' -', '-');
}

function short(value: number): string {
  return String(value).replace(/^(-?)0\./, '$1.');
}

/** The backdrop as a vertical gradient; without colours of its own, sampled where nothing covers it. */
function backdrop(ramp: readonly RampStop[], whole: ImageData, cut: ImageData): string {
  const sampled = Array.from({ length: STOPS }, (_, stop) => {
    const offset = stop / (STOPS - 1);
    const color = emptyColor(whole, cut, Math.round(offset * (whole.height - 1)));
    return color === undefined ? [] : [{ offset, color: hexOf(color) }];
  });
  const own = ramp.map(({ at, color }) => ({ offset: Number((1 - at).toFixed(3)), color })).toReversed();
  const stops = (own.length > 0 ? own : sampled.flat()).map(
    ({ offset, color }) => `<stop offset="${offset}" stop-color="${color}"/>`,
  );
  return [
    '<g id="background">',
    `<linearGradient id="backdrop" x2="0" y2="1">${stops.join('')}</linearGradient>`,
    '<rect width="100%" height="100%" fill="url(#backdrop)"/>',
    '</g>',
  ].join('\n');
}

/** The backdrop's colour in a row, at a pixel that nothing covers. */
function emptyColor(whole: ImageData, cut: ImageData, row: number): number | undefined {
  const from = row * whole.width;
  const [colors, holes] = [whole, cut].map(({ data }) => new Uint32Array(data.buffer, 4 * from, whole.width));
  const at = holes.findIndex((pixel) => pixel >>> 24 <= NOISE);
  return at < 0 ? undefined : colors[at];
}

/** The pixel of a colour, each channel 0 to 255. */
function pixelOf([red, green, blue]: readonly number[]): number {
  return ((0xff << 24) | (blue << 16) | (green << 8) | red) >>> 0;
}

function hexOf(color: number): string {
  const channel = (shift: number) => ((color >>> shift) & 0xff).toString(16).padStart(2, '0');
  return `#${channel(0)}${channel(8)}${channel(16)}`;
}

const OUTSIDE = -1;

/** Right, down, left, up. */
const STEPS = [
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
] as const;

/**
 * Traces the closed outlines of all pixels with one index. The inside is on the right; holes run in the opposite
 * direction. Adjacent regions share exactly the same points: outlines are split where three regions meet, and each
 * piece is simplified separately, in a canonical direction.
 * @param tolerance maximum distance between the simplified line and the pixel edges, in pixels
 */
export function traceRegion(labels: Labels, number: number, tolerance: number): Point[][] {
  const seen = new Uint8Array(labels.of.length);
  const outlines: Point[][] = [];
  for (let at = 0; at < labels.of.length; ++at) {
    // Each outline contains a top edge of a pixel, which is traversed to the right.
    if (seen[at] || labels.of[at] !== number || above(labels, at) === number) continue;
    const corners = walk(labels, number, at, seen);
    const outline = simplified(corners, labels, tolerance);
    if (outline.length > 2) outlines.push(outline);
  }
  return outlines;
}

function above({ of, width }: Labels, at: number): number | undefined {
  return of[at - width];
}

/** The index at a position; outside the image a value that no pixel has. */
function numberAt({ of, width, height }: Labels, x: number, y: number): number {
  return x < 0 || y < 0 || x >= width || y >= height ? OUTSIDE : of[y * width + x];
}

/** Follows an outline from the top left corner of a pixel back to it, and marks the top edges that it passes. */
function walk(labels: Labels, number: number, first: number, seen: Uint8Array): Point[] {
  const start: Point = [first % labels.width, Math.floor(first / labels.width)];
  const points: Point[] = [];
  let [x, y] = start;
  let heading = 0;
  do {
    points.push([x, y]);
    if (heading === 0) seen[y * labels.width + x] = 1;
    x += STEPS[heading][0];
    y += STEPS[heading][1];
    heading = nextHeading(labels, number, x, y, heading);
  } while (x !== start[0] || y !== start[1] || heading !== 0);
  return points;
}

/** Keeps the region on the right. Two pixels of a region that touch only at a corner stay separate. */
function nextHeading(labels: Labels, number: number, x: number, y: number, heading: number): number {
  const isInside = (ahead: number) => {
    const [px, py] = [STEPS[ahead], STEPS[(ahead + 1) % 4]].reduce(([sx, sy], [dx, dy]) => [sx + dx, sy + dy], [0, 0]);
    return numberAt(labels, x + (px - 1) / 2, y + (py - 1) / 2) === number;
  };
  if (!isInside(heading)) return (heading + 1) % 4;
  return isInside((heading + 3) % 4) ? (heading + 3) % 4 : heading;
}

/** Splits an outline where three regions meet or at the image border, and simplifies each piece. */
function simplified(corners: Point[], labels: Labels, tolerance: number): Point[] {
  const joints = corners.flatMap((corner, at) => (isJoint(labels, corner) ? [at] : []));
  if (joints.length === 0) joints.push(lowest(corners));
  return joints.flatMap((joint, piece) => {
    const end = joints[(piece + 1) % joints.length];
    const arc = between(corners, joint, end);
    return simplifyArc(arc, tolerance).slice(0, -1);
  });
}

function between(corners: Point[], from: number, to: number): Point[] {
  return to > from ? corners.slice(from, to + 1) : [...corners.slice(from), ...corners.slice(0, to + 1)];
}

function isJoint(labels: Labels, [x, y]: Point): boolean {
  const around = [
    numberAt(labels, x - 1, y - 1),
    numberAt(labels, x, y - 1),
    numberAt(labels, x, y),
    numberAt(labels, x - 1, y),
  ];
  const changes = around.filter((number, at) => number !== around[(at + 1) % 4]).length;
  const isCornerOfPicture = around.filter((number) => number === OUTSIDE).length === 3;
  return changes > 2 || isCornerOfPicture;
}

/** Start of a closed outline without joints, independent of its direction. */
function lowest(corners: Point[]): number {
  let best = 0;
  corners.forEach(([x, y], at) => {
    const [bestX, bestY] = corners[best];
    if (y < bestY || (y === bestY && x < bestX)) best = at;
  });
  return best;
}
