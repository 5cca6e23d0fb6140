import { create } from '../ui/dom.ts';
import { strings } from '../strings.ts';

/** Resting heights of the sheet, as fractions of the window. The smoke uses the space above the lower one. */
const RESTS = { half: 0.48, full: 0.88 } as const;
/** The sheet closes when it is released below this fraction of the window. */
const CLOSES_BELOW = 0.28;
/** Maximum movement of a tap in CSS pixels. */
const TAP_PIXELS = 6;

/**
 * Handle of the bottom sheet on phones. Dragging snaps to one of two heights or, far down, closes the sheet. A tap or
 * Enter switches between the heights.
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
    this.setFull(false);
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
    else this.setFull(share > (RESTS.half + RESTS.full) / 2);
  }

  private press(event: KeyboardEvent): void {
    if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return;
    event.preventDefault();
    event.stopPropagation();
    if (event.key === 'ArrowUp') this.setFull(true);
    else if (this.isFull) this.setFull(false);
    else this.closeAtHalf();
  }

  /**
   * Ignores the click that follows a mouse drag. Touch drags fire no click, so a later click by key must still count.
   */
  private toggle(isByKey: boolean): void {
    const endsDrag = this.held?.isMoved && !isByKey;
    this.held = undefined;
    if (!endsDrag) this.setFull(!this.isFull);
  }

  private get isFull(): boolean {
    return this.sheet.classList.contains('is-full');
  }

  private setFull(isFull: boolean): void {
    this.sheet.classList.toggle('is-full', isFull);
    this.element.setAttribute('aria-expanded', String(isFull));
  }

  private closeAtHalf(): void {
    this.setFull(false);
    this.close();
  }
}
