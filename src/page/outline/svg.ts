/**
 * Reads the shapes of an SVG file. Of the document, only the geometry and the plain colours of basic shapes are used: no
 * script runs, and nothing is requested.
 */
import { ShapeError } from '../../base/errors.ts';

/** The matrix [a b c d e f] of SVG and of canvases. */
type Matrix = readonly number[];

interface Paint {
  /** A colour as in SVG; undefined for none. */
  readonly fill: string | undefined;
  readonly stroke: string | undefined;
  readonly strokeWidth: number;
  readonly rule: CanvasFillRule;
}

export interface SvgShape extends Paint {
  readonly matrix: Matrix;
  /** Path data. */
  readonly path: string;
}

export interface SvgPicture {
  readonly box: readonly [x: number, y: number, width: number, height: number];
  readonly shapes: readonly SvgShape[];
}

const MAX_SHAPES = 5000;
/** Maximum depth of nested groups. */
const MAX_DEPTH = 100;
const GROUPS = ['svg', 'g', 'a', 'switch'];
const IDENTITY: Matrix = [1, 0, 0, 1, 0, 0];
const BLACK: Paint = { fill: '#000000', stroke: undefined, strokeWidth: 1, rule: 'nonzero' };

/** Draws a picture in its own units. */
export interface Picture {
  readonly box: readonly [x: number, y: number, width: number, height: number];
  draw(context: OffscreenCanvasRenderingContext2D): void;
}

/** @throws ShapeError if the text is no SVG or has no shapes */
export function pictureOfSvg(text: string): Picture {
  const { box, shapes } = readSvg(text);
  const paths = shapes.map((shape) => ({ ...shape, path: new Path2D(shape.path) }));
  return {
    box,
    draw(context) {
      for (const { path, matrix, fill, stroke, strokeWidth, rule } of paths) {
        context.save();
        context.transform(...(matrix as DOMMatrix2DTuple));
        context.fillStyle = context.strokeStyle = '#000000';
        if (fill !== undefined) {
          context.fillStyle = fill;
          context.fill(path, rule);
        }
        if (stroke !== undefined) {
          context.strokeStyle = stroke;
          context.lineWidth = strokeWidth;
          context.stroke(path);
        }
        context.restore();
      }
    },
  };
}

type DOMMatrix2DTuple = [number, number, number, number, number, number];

/** @throws ShapeError if the file is no SVG or has no shapes */
export function readSvg(text: string): SvgPicture {
  const root = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
  if (root.localName !== 'svg') throw new ShapeError('It is not a valid SVG file.');
  const classes = classesOf(root);
  const shapes: SvgShape[] = [];
  const walk = (element: Element, paint: Paint, matrix: Matrix, depth: number): void => {
    const style = styleOf(element, classes);
    if (style('display') === 'none' || style('visibility') === 'hidden' || Number(style('opacity')) === 0) return;
    const own = paintOf(style, paint);
    const placed = element.getAttribute('transform')?.matchAll(/(\w+)\s*\(([^)]*)\)/g) ?? [];
    const inner = [...placed].reduce((outer, [, name, list]) => product(outer, matrixOf(name, numbers(list))), matrix);
    const path = pathOf(element);
    if (path && shapes.length < MAX_SHAPES) shapes.push({ ...own, matrix: inner, path });
    if (depth > MAX_DEPTH || !GROUPS.includes(element.localName)) return;
    for (const child of element.children) walk(child, own, inner, depth + 1);
  };
  walk(root, BLACK, IDENTITY, 0);
  if (shapes.length === 0) throw new ShapeError('It has no shapes. Convert text and symbols to paths first.');
  return { box: boxOf(root), shapes };
}

/** The box that is shown. */
function boxOf(root: Element): SvgPicture['box'] {
  const [x, y, width, height] = numbers(root.getAttribute('viewBox') ?? '');
  if (width > 0 && height > 0) return [x, y, width, height];
  const side = (name: string): number => parseFloat(root.getAttribute(name) ?? '') || 100;
  return [0, 0, side('width'), side('height')];
}

/** Style sheets with one class a rule, as drawing programs write them. */
function classesOf(root: Element): ReadonlyMap<string, string> {
  const sheets = [...root.getElementsByTagName('style')].map(({ textContent }) => textContent).join('\n');
  const rules = [...sheets.matchAll(/([^{}]+)\{([^{}]*)\}/g)];
  const named = rules.flatMap(([, names, body]) =>
    names.split(',').map((name) => [name.trim().slice(1), body] as const),
  );
  const classes = new Map<string, string>();
  for (const [name, body] of named) classes.set(name, `${classes.get(name) ?? ''};${body}`);
  return classes;
}

/** A property of an element: from its style, its classes or its attributes. */
function styleOf(element: Element, classes: ReadonlyMap<string, string>): (name: string) => string | undefined {
  const rules = [...element.classList].map((name) => classes.get(name) ?? '');
  const declared = [...rules, element.getAttribute('style') ?? ''].join(';').split(';');
  const values = new Map(declared.map((each) => [each.split(':')[0].trim(), each.split(':')[1]?.trim()] as const));
  return (name) => values.get(name) ?? element.getAttribute(name)?.trim();
}

function paintOf(style: (name: string) => string | undefined, outer: Paint): Paint {
  const color = (name: string, inherited: string | undefined): string | undefined => {
    const value = style(name);
    if (value === undefined || value === 'inherit') return inherited;
    if (value === 'none' || value === 'transparent' || Number(style(`${name}-opacity`)) === 0) return undefined;
    // Gradients and patterns become white.
    return value.startsWith('url') ? '#ffffff' : value;
  };
  const rule = style('fill-rule');
  return {
    fill: color('fill', outer.fill),
    stroke: color('stroke', outer.stroke),
    strokeWidth: parseFloat(style('stroke-width') ?? '') || outer.strokeWidth,
    rule: rule === 'evenodd' || rule === 'nonzero' ? rule : outer.rule,
  };
}

/** The path of a basic shape; undefined for other elements. */
function pathOf(element: Element): string | undefined {
  const of = (name: string): number => parseFloat(element.getAttribute(name) ?? '') || 0;
  switch (element.localName) {
    case 'path':
      return element.getAttribute('d') ?? undefined;
    case 'rect':
      return `M${of('x')} ${of('y')}h${of('width')}v${of('height')}h${-of('width')}z`;
    case 'circle':
      return ellipse(of('cx'), of('cy'), of('r'), of('r'));
    case 'ellipse':
      return ellipse(of('cx'), of('cy'), of('rx'), of('ry'));
    case 'line':
      return `M${of('x1')} ${of('y1')}L${of('x2')} ${of('y2')}`;
    case 'polygon':
    case 'polyline':
      return `M${numbers(element.getAttribute('points') ?? '').join(' ')}${element.localName === 'polygon' ? 'z' : ''}`;
    default:
      return undefined;
  }
}

function ellipse(x: number, y: number, rx: number, ry: number): string {
  return `M${x - rx} ${y}a${rx} ${ry} 0 1 0 ${2 * rx} 0a${rx} ${ry} 0 1 0 ${-2 * rx} 0z`;
}

function numbers(list: string): number[] {
  return (list.match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/gi) ?? []).map(Number);
}

/** The matrix of one function of a `transform`. */
function matrixOf(name: string, [a = 0, b, c, d, e, f]: readonly number[]): Matrix {
  const turn = (a * Math.PI) / 180;
  switch (name) {
    case 'matrix':
      return [a, b, c, d, e, f];
    case 'translate':
      return [1, 0, 0, 1, a, b ?? 0];
    case 'scale':
      return [a, 0, 0, b ?? a, 0, 0];
    case 'skewX':
      return [1, 0, Math.tan(turn), 1, 0, 0];
    case 'skewY':
      return [1, Math.tan(turn), 0, 1, 0, 0];
    case 'rotate': {
      const [cos, sin, x, y] = [Math.cos(turn), Math.sin(turn), b ?? 0, c ?? 0];
      return [cos, sin, -sin, cos, x - cos * x + sin * y, y - sin * x - cos * y];
    }
    default:
      return IDENTITY;
  }
}

function product([a, b, c, d, e, f]: Matrix, [A, B, C, D, E, F]: Matrix): Matrix {
  return [a * A + c * B, b * A + d * B, a * C + c * D, b * C + d * D, a * E + c * F + e, b * E + d * F + f];
}
