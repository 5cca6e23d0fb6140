import type { Stage } from '../../index.ts';
import { create, createSvg, textButton } from '../ui/dom.ts';
import { strings } from '../strings.ts';
import type { PicturePlace } from './depth.ts';
import { flowOf, type DrawnFlow } from './stroke.ts';

/** Share of the picture that a stroke by the keyboard is long. */
const REACH = 0.25;

/**
 * Lies over the picture while a flow is drawn, by mouse, pen or a finger, or by a key. Two fingers and the wheel move the
 * camera, and hands may rest on the screen while a pen draws.
 */
export class FlowBrush {
  readonly element: HTMLElement;
  private readonly stage: Stage;
  private readonly onDrawn: (flow: DrawnFlow) => void;
  private readonly onClose: () => void;
  private readonly line = createSvg('path');
  private stroke: PicturePlace[] = [];
  /** The latest event of the pointer that draws. */
  private pointer: PointerEvent | undefined;

  /**
   * @param onDrawn called with each flow
   * @param onClose called when nothing was drawn
   */
  constructor(stage: Stage, onDrawn: (flow: DrawnFlow) => void, onClose: () => void) {
    this.stage = stage;
    this.onDrawn = onDrawn;
    this.onClose = onClose;
    const { how, cancel } = strings.flow;
    const drawing = createSvg('svg', { 'aria-hidden': 'true' }, this.line);
    const note = create(
      'p',
      { class: 'card flow-note' },
      how,
      textButton('quiet', cancel, () => this.close()),
    );
    const attributes = {
      class: 'flow-brush',
      role: 'group',
      tabindex: '0',
      'aria-label': strings.flow.draw,
      hidden: true,
    };
    this.element = create('div', attributes, drawing, note);
    this.listen();
  }

  private get canvas(): HTMLCanvasElement {
    return this.stage.canvas as HTMLCanvasElement;
  }

  open(): void {
    this.element.hidden = false;
    this.element.focus();
  }

  private close(): void {
    this.end();
    this.onClose();
  }

  private end(): void {
    this.element.hidden = true;
    this.discard();
  }

  private discard(): void {
    this.pointer = undefined;
    this.stroke = [];
    this.line.setAttribute('d', '');
  }

  private listen(): void {
    const { element } = this;
    element.addEventListener('pointerdown', (event) => this.down(event));
    element.addEventListener('pointermove', (event) => this.move(event));
    element.addEventListener('pointerup', (event) => this.up(event));
    for (const name of ['pointercancel', 'lostpointercapture'] as const) {
      element.addEventListener(name, ({ pointerId }) => pointerId === this.pointer?.pointerId && this.discard());
    }
    element.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    // Of a pen that is held.
    element.addEventListener('contextmenu', (event) => event.preventDefault());
    element.addEventListener('keydown', (event) => this.press(event));
  }

  private down(event: PointerEvent): void {
    const { pointer } = this;
    const isOnNote = event.target instanceof Element && event.target.closest('.flow-note');
    if (isOnNote || (pointer?.pointerType === 'pen' && event.pointerType !== 'pen')) return;
    if (!event.isPrimary) return this.handOver(pointer ? [pointer, event] : [event]);
    if (event.button !== 0 || (pointer && event.pointerType !== 'pen')) return;
    this.element.setPointerCapture(event.pointerId);
    this.pointer = event;
    this.stroke = [this.placeOf(event)];
  }

  /** Leaves fingers to the picture, which captures them. */
  private handOver(fingers: readonly PointerEvent[]): void {
    this.discard();
    for (const { pointerId, pointerType, isPrimary, clientX, clientY } of fingers) {
      const finger = { pointerId, pointerType, isPrimary, clientX, clientY, buttons: 1, bubbles: true };
      this.canvas.dispatchEvent(new PointerEvent('pointerdown', finger));
    }
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const { deltaX, deltaY, deltaMode } = event;
    if (!this.pointer) this.canvas.dispatchEvent(new WheelEvent('wheel', { deltaX, deltaY, deltaMode }));
  }

  private move(event: PointerEvent): void {
    if (event.pointerId !== this.pointer?.pointerId) return;
    this.pointer = event;
    const events = event.getCoalescedEvents?.() ?? [];
    this.stroke.push(...(events.length > 0 ? events : [event]).map((each) => this.placeOf(each)));
    const box = this.element.getBoundingClientRect();
    const { left, top } = this.canvas.getBoundingClientRect();
    const places = this.stroke.map(
      ({ x, y }) => `${(x + left - box.left).toFixed(1)} ${(y + top - box.top).toFixed(1)}`,
    );
    this.line.setAttribute('d', `M${places.join('L')}`);
  }

  private up(event: PointerEvent): void {
    if (event.pointerId !== this.pointer?.pointerId) return;
    this.finish([...this.stroke, this.placeOf(event)]);
  }

  /** Enter draws a straight stroke in the middle, whose points have handles. */
  private press(event: KeyboardEvent): void {
    // The page has shortcuts on the same keys.
    if (event.key !== 'Tab') event.stopPropagation();
    if (event.key === 'Escape') return this.close();
    if (event.key !== 'Enter' || event.target !== this.element) return;
    event.preventDefault();
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const at = (share: number) => ({ x: width * (0.5 + share * REACH), y: height * 0.5 });
    this.finish([at(-1), at(0), at(1)], true);
  }

  /** @param keepsAll whether also points on a straight line stay */
  private finish(stroke: readonly PicturePlace[], keepsAll = false): void {
    const flow = flowOf(this.stage, stroke, keepsAll);
    this.end();
    if (flow) this.onDrawn(flow);
    else this.open();
  }

  private placeOf({ clientX, clientY }: MouseEvent): PicturePlace {
    const { left, top } = this.canvas.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }
}
