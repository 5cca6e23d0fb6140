import type { Stage } from '../../stage/stage.ts';
import { iconButton } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { strings } from '../strings.ts';

/** Height of the picture at which things begin to fall that nobody pointed at, as a share from above. */
const HEIGHT = 0.22;
/** They fall beside each other: so far from the middle at most, as a share of the smaller side. */
const SPREAD = 0.16;
const GOLDEN = 0.618;

/** Drops balls and crates into scenes with physics: where a pointer is, or above the middle. */
export class DropThings {
  /** Hidden where nothing can be dropped. */
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

  /** At the pointer while that is over the smoke. */
  here(): void {
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
