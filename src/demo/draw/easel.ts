import { LOBE_SHAPES, SIDE, type Line, type Point } from '../../internal.ts';
import { create, uniqueId } from '../ui/dom.ts';
import { strings } from '../strings.ts';
import { PAPER, withFill, withFold, withStroke, type Brush, type Sketch } from './sketch.ts';

/** Pixels of the canvas for one unit of the sheet. */
const SCALE = 2;
/** Steps of the cursor in units: of an arrow key, and with Shift. */
const [STEP, LONG_STEP] = [4, 16];
/** Least distance between two points of a fold in units. */
const FOLD_STEP = 3;
const MIDDLE: Point = [SIDE / 2, SIDE / 2];
const ERASER_BUTTON = 32;
const ARROWS: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** What the easel draws on and with. */
export interface Draft {
  readonly brush: Brush;
  readonly sketch: Sketch;
  /** Number of the variation, from 0. */
  readonly current: number;
  /** Takes the sketch that a stroke changed. @param isOver whether the stroke has ended */
  edit(sketch: Sketch, isOver: boolean): void;
}

/** The sheet of paper: draws with pointers, or with a cursor that keys move, and shows the sketch. */
export class Easel {
  readonly canvas = create('canvas', {
    class: 'draw-paper',
    width: SIDE * SCALE,
    height: SIDE * SCALE,
    tabindex: 0,
    role: 'application',
    'aria-label': strings.drawing.paper,
    'aria-describedby': uniqueId(),
  });
  readonly help = create('p', { class: 'read-aloud', id: this.canvas.getAttribute('aria-describedby')! });
  private readonly draft: Draft;
  private readonly context = this.canvas.getContext('2d')!;
  private readonly pixels = new ImageData(SIDE, SIDE);
  private readonly buffer = new OffscreenCanvas(SIDE, SIDE);
  /** The pointer or, as -1, the key that draws. */
  private held: number | undefined;
  private line: Point[] = [];
  private cursor = MIDDLE;
  private hasCursor = false;

  constructor(draft: Draft) {
    this.draft = draft;
    this.help.textContent = strings.drawing.how;
    const { canvas } = this;
    canvas.addEventListener('pointerdown', (event) => this.press(event));
    canvas.addEventListener('pointermove', (event) => this.drag(event));
    for (const end of ['pointerup', 'pointercancel'] as const) {
      canvas.addEventListener(end, ({ pointerId }) => this.end(pointerId));
    }
    canvas.addEventListener('keydown', (event) => this.type(event));
    canvas.addEventListener('keyup', ({ key }) => key === ' ' && this.end(-1));
    canvas.addEventListener('blur', () => {
      this.end(-1);
      this.hasCursor = false;
      this.show();
    });
  }

  show(): void {
    const { context, draft } = this;
    context.setTransform(SCALE, 0, 0, SCALE, 0, 0);
    context.clearRect(0, 0, SIDE, SIDE);
    this.disc(MIDDLE, PAPER, '#8699ae');
    this.showGhost();
    this.showPixels();
    for (const fold of draft.sketch.folds) this.showFold(fold);
    if (draft.brush.tool === 'fold' && this.line.length > 1) this.showFold(this.line);
    if (draft.brush.isMirrored) this.stroke([[SIDE / 2, 4], [SIDE / 2, SIDE - 4]], '#1d172088', 1, [2, 4]); // prettier-ignore
    if (!this.hasCursor) return;
    const radius = Math.max(3, draft.brush.width / 2);
    for (const [color, width] of [['#fffdf6', 3.5], ['#b3271d', 1.5]] as const) this.ring(this.cursor, radius, color, width); // prettier-ignore
  }

  /** The outline of a default puff. */
  private showGhost(): void {
    const { context } = this;
    const { lobes } = LOBE_SHAPES[this.draft.current % LOBE_SHAPES.length];
    context.beginPath();
    for (const { center, radius } of lobes) {
      const [x, y] = [(1 + center[0]) * (SIDE / 2), (1 - center[1]) * (SIDE / 2)];
      context.moveTo(x + (radius * SIDE) / 2, y);
      context.arc(x, y, (radius * SIDE) / 2, 0, 2 * Math.PI);
    }
    context.fillStyle = '#ffffff30';
    context.fill();
  }

  private showPixels(): void {
    const { pixels, colors } = this.draft.sketch;
    const words = new Uint32Array(this.pixels.data.buffer);
    const rgba = [
      0,
      ...colors.map((color) => 0xff000000 | parseInt(color.slice(1).replace(/(..)(..)(..)/, '$3$2$1'), 16)),
    ];
    pixels.forEach((pixel, at) => (words[at] = rgba[pixel]));
    this.buffer.getContext('2d')!.putImageData(this.pixels, 0, 0);
    this.context.drawImage(this.buffer, 0, 0);
  }

  private showFold(line: Line): void {
    this.stroke(line, '#fffdf6', 4, []);
    this.stroke(line, '#1d1720', 2, [5, 4]);
  }

  private stroke(line: Line, color: string, width: number, dash: number[]): void {
    const { context } = this;
    context.beginPath();
    for (const point of line) context.lineTo(...point);
    Object.assign(context, { strokeStyle: color, lineWidth: width, lineJoin: 'round', lineCap: 'round' });
    context.setLineDash(dash);
    context.stroke();
    context.setLineDash([]);
  }

  private disc(center: Point, radius: number, color: string): void {
    this.context.beginPath();
    this.context.arc(...center, radius, 0, 2 * Math.PI);
    this.context.fillStyle = color;
    this.context.fill();
  }

  private ring(center: Point, radius: number, color: string, width: number): void {
    this.context.beginPath();
    this.context.arc(...center, radius, 0, 2 * Math.PI);
    Object.assign(this.context, { strokeStyle: color, lineWidth: width });
    this.context.stroke();
  }

  private press(event: PointerEvent): void {
    // A second finger or another button does not draw.
    if (this.held !== undefined || !event.isPrimary || (event.button > 0 && !(event.buttons & ERASER_BUTTON))) return;
    this.canvas.setPointerCapture(event.pointerId);
    this.hasCursor = false;
    this.begin(event.pointerId, this.placeOf(event), event);
  }

  private drag(event: PointerEvent): void {
    if (event.pointerId !== this.held) return;
    const all = event.getCoalescedEvents();
    for (const each of all.length > 0 ? all : [event]) this.move(this.placeOf(each), each);
    this.show();
  }

  private placeOf({ clientX, clientY }: PointerEvent): Point {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    return [((clientX - left) / width) * SIDE, ((clientY - top) / height) * SIDE];
  }

  private begin(id: number, at: Point, pen?: PointerEvent): void {
    const { brush, sketch } = this.draft;
    this.held = id;
    this.line = [at];
    if (brush.tool === 'fill') this.draft.edit(withFill(sketch, brush, at), false);
    else if (brush.tool !== 'fold') this.draft.edit(withStroke(sketch, pressed(brush, pen), at, at), false);
  }

  private move(at: Point, pen?: PointerEvent): void {
    const { brush, sketch } = this.draft;
    const last = this.line[this.line.length - 1];
    if (brush.tool === 'pen' || brush.tool === 'eraser') {
      this.line = [at];
      this.draft.edit(withStroke(sketch, pressed(brush, pen), last, at), false);
    } else if (brush.tool === 'fold' && Math.hypot(at[0] - last[0], at[1] - last[1]) >= FOLD_STEP) this.line.push(at);
  }

  private end(id: number): void {
    if (this.held === undefined || this.held !== id) return;
    const { brush, sketch } = this.draft;
    const line = this.line;
    this.held = undefined;
    this.line = [];
    const isFold = brush.tool === 'fold' && line.length > 1;
    this.draft.edit(isFold ? withFold(sketch, brush, line) : sketch, true);
  }

  private type(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = ARROWS[event.key];
    if (!arrow && event.key !== ' ') return;
    event.preventDefault();
    this.hasCursor = true;
    if (arrow) {
      const step = event.shiftKey ? LONG_STEP : STEP;
      const [x, y] = this.cursor.map((place, axis) => Math.min(SIDE, Math.max(0, place + step * arrow[axis])));
      this.cursor = [x, y];
      if (this.held === -1) this.move(this.cursor);
    } else if (this.held === undefined) this.begin(-1, this.cursor);
    this.show();
  }
}

/** The brush of a pointer: pens have pressure, and an eraser at their other end. */
function pressed(brush: Brush, pen?: PointerEvent): Brush {
  if (pen?.pointerType !== 'pen') return brush;
  const tool = pen.buttons & ERASER_BUTTON ? 'eraser' : brush.tool;
  return { ...brush, tool, width: brush.width * (0.3 + 1.4 * pen.pressure) };
}
