import type { Stage } from '../stage/stage.ts';
import { iconButton } from './dom.ts';
import { icon } from './icons.ts';
import { strings } from './strings.ts';

/** Blowing for who has no Alt key: a button by which drags beside things blow, and a gust by the keyboard. */
export class Blowing {
  readonly element: HTMLButtonElement;
  private readonly stage: Stage;
  private readonly canvas: HTMLCanvasElement;
  private pointer: { x: number; y: number } | undefined;
  private isOn = false;

  constructor(stage: Stage, canvas: HTMLCanvasElement) {
    this.stage = stage;
    this.canvas = canvas;
    this.element = iconButton('icon-button', strings.blow, icon('wind'), () => this.toggle());
    this.element.setAttribute('aria-pressed', 'false');
    canvas.addEventListener('pointermove', ({ offsetX: x, offsetY: y }) => (this.pointer = { x, y }));
    canvas.addEventListener('pointerleave', () => (this.pointer = undefined));
  }

  /** Whether a drag that grabs nothing blows instead of turning the view. */
  get takesDrags(): boolean {
    return this.isOn;
  }

  /** A gust away from the viewer: where the pointer is, or in the middle. */
  here(): void {
    const { clientWidth, clientHeight } = this.canvas;
    this.stage.blow(this.pointer ?? { x: clientWidth / 2, y: clientHeight / 2 });
  }

  private toggle(): void {
    this.isOn = !this.isOn;
    this.element.setAttribute('aria-pressed', String(this.isOn));
  }
}
