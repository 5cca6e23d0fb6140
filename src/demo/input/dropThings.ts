import type { Stage } from '../../index.ts';
import { iconButton } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { strings } from '../strings.ts';

/** Height at which objects drop without a pointer, as a fraction of the canvas from the top. */
const HEIGHT = 0.22;
/**
 * Maximum distance from the middle, as a fraction of the canvas's smaller side, so that objects fall next to each
 * other.
 */
const SPREAD = 0.16;
const GOLDEN = 0.618;

/** Drops balls and crates into scenes with physics, at the pointer or above the middle. */
export class DropThings {
  /** Hidden where the scene does not support it. */
  readonly element: HTMLButtonElement;
  private readonly stage: Stage;
  private readonly canvas: HTMLCanvasElement;
  private pointer: { x: number; y: number } | undefined;
  private count = 0;

  constructor(stage: Stage, canvas: HTMLCanvasElement) {
    this.stage = stage;
    this.canvas = canvas;
    this.element = iconButton('icon-button', strings.drop, icon('drop'), () => this.above());
    canvas.addEventListener('pointermove', ({ offsetX: x, offsetY: y }) => (this.pointer = { x, y }));
    canvas.addEventListener('pointerleave', () => (this.pointer = undefined));
    canvas.addEventListener('dblclick', ({ offsetX, offsetY }) => stage.drop(offsetX, offsetY));
    const show = () => (this.element.hidden = stage.dropCount === 0);
    stage.on('statechange', show);
    show();
  }

  /** Drops an object at the pointer, or above the middle when the pointer is not over the smoke. */
  dropAtPointer(): void {
    if (this.pointer) this.stage.drop(this.pointer.x, this.pointer.y);
    else this.above();
  }

  private above(): void {
    const { clientWidth, clientHeight } = this.canvas;
    const aside = SPREAD * Math.min(clientWidth, clientHeight) * (2 * ((GOLDEN * this.count) % 1) - 1);
    this.count++;
    this.stage.drop(clientWidth / 2 + aside, HEIGHT * clientHeight);
  }
}
