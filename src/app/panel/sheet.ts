import { create } from '../ui/dom.ts';
import { strings } from '../strings.ts';

/** Heights that a sheet rests at, as shares of the window; the smoke keeps what the lower one leaves. */
const RESTS = { half: 0.48, full: 0.88 } as const;
/** Let go below this share of the window it closes. */
const CLOSES_BELOW = 0.28;
/** A finger that goes less far has tapped, CSS pixels. */
const TAP_PIXELS = 6;

/**
 * The grip of a sheet that comes from below on phones: dragged up and down it rests at two heights, dragged far down it
 * closes; a tap or Enter goes from one height to the other.
 */
export class SheetGrip {
  readonly element = create('button', { type: 'button', class: 'grip', 'aria-label': strings.panel.sheet });
  private readonly sheet: HTMLElement;
  private readonly close: () => void;
  private held: { id: number; y: number; height: number; isMoved: boolean } | undefined;

  constructor(sheet: HTMLElement, close: () => void) {
    this.sheet = sheet;
    this.close = close;
    const { element } = this;
    element.addEventListener('pointerdown', (event) => this.grab(event));
    element.addEventListener('pointermove', (event) => this.drag(event));
    element.addEventListener('pointerup', (event) => this.release(event));
    element.addEventListener('pointercancel', (event) => this.release(event));
    element.addEventListener('keydown', (event) => this.press(event));
    element.addEventListener('click', ({ detail }) => this.toggle(detail === 0));
    this.rest(false);
  }

  private grab({ pointerId, clientY }: PointerEvent): void {
    this.element.setPointerCapture(pointerId);
    this.held = { id: pointerId, y: clientY, height: this.sheet.offsetHeight, isMoved: false };
  }

  private drag({ pointerId, clientY }: PointerEvent): void {
    if (pointerId !== this.held?.id) return;
    const up = this.held.y - clientY;
    this.held.isMoved ||= Math.abs(up) > TAP_PIXELS;
    if (!this.held.isMoved) return;
    this.sheet.classList.add('is-dragged');
    this.sheet.style.height = `${Math.min(Math.max(this.held.height + up, 60), innerHeight * RESTS.full)}px`;
  }

  private release({ pointerId }: PointerEvent): void {
    if (pointerId !== this.held?.id) return;
    const share = this.sheet.offsetHeight / innerHeight;
    this.sheet.classList.remove('is-dragged');
    this.sheet.style.removeProperty('height');
    if (!this.held.isMoved) this.held = undefined;
    else if (share < CLOSES_BELOW) this.closeAtHalf();
    else this.rest(share > (RESTS.half + RESTS.full) / 2);
  }

  private press(event: KeyboardEvent): void {
    if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return;
    event.preventDefault();
    event.stopPropagation();
    if (event.key === 'ArrowUp') this.rest(true);
    else if (this.isFull) this.rest(false);
    else this.closeAtHalf();
  }

  /** The click that ends a drag is none; after a finger's drag none comes, so that a key's click must not be taken for it. */
  private toggle(isByKey: boolean): void {
    const endsDrag = this.held?.isMoved && !isByKey;
    this.held = undefined;
    if (!endsDrag) this.rest(!this.isFull);
  }

  private get isFull(): boolean {
    return this.sheet.classList.contains('is-full');
  }

  private rest(isFull: boolean): void {
    this.sheet.classList.toggle('is-full', isFull);
    this.element.setAttribute('aria-expanded', String(isFull));
  }

  private closeAtHalf(): void {
    this.rest(false);
    this.close();
  }
}
