import type { Stage } from '../../index.ts';
import { ORBIT_PER_PIXEL, spread } from '../../internal.ts';
import { QUIET_MS } from '../editor/editor.ts';

const ZOOM_PER_PIXEL = 0.0015;
// CSS pixels per line, for wheels that report lines.
const PIXELS_PER_LINE = 32;

// A blow uses the movement within 1/60 s. Samples less than half of that apart give an unreliable direction.
const BLOW_MS = 1000 / 60;

interface Point {
  x: number;
  y: number;
  /** Timestamp of the position in milliseconds. */
  at: number;
  does: 'orbit' | 'pan' | 'blow';
}

/**
 * Passes mouse, pen and touch input to the stage. A drag that grabs no rigid orbits, pans or zooms the camera, or
 * blows.
 */
export class Pointers {
  private readonly stage: Stage;
  private readonly canvas: HTMLCanvasElement;
  private readonly loose = new Map<number, Point>();
  private readonly holding = new Set<number>();
  private readonly orbitEnd: GestureEnd;
  private readonly blows: () => boolean;

  /**
   * @param orbitEnd notified when the camera has been orbited, panned or zoomed
   * @param blows whether drags blow without a modifier key
   */
  constructor(stage: Stage, canvas: HTMLCanvasElement, orbitEnd: GestureEnd, blows: () => boolean) {
    this.stage = stage;
    this.canvas = canvas;
    this.orbitEnd = orbitEnd;
    this.blows = blows;
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.up(event, 'up'));
    canvas.addEventListener('pointercancel', (event) => this.up(event, 'cancel'));
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  }

  private down(event: PointerEvent): void {
    this.canvas.setPointerCapture(event.pointerId);
    if (event.button === 0 && this.forward('down', event) === 'rigid') {
      this.holding.add(event.pointerId);
      this.canvas.classList.add('is-holding');
      return;
    }
    if (this.loose.size === 0) this.orbitEnd.now();
    const does = event.button !== 0 || event.shiftKey ? 'pan' : event.altKey || this.blows() ? 'blow' : 'orbit';
    this.loose.set(event.pointerId, { x: event.clientX, y: event.clientY, at: event.timeStamp, does });
  }

  private move(event: PointerEvent): void {
    if (this.holding.has(event.pointerId)) this.forward('move', event);
    const point = this.loose.get(event.pointerId);
    if (!point) return;
    const before = this.spread();
    const [dx, dy] = [event.clientX - point.x, event.clientY - point.y];
    const elapsed = event.timeStamp - point.at;
    Object.assign(point, { x: event.clientX, y: event.clientY, at: event.timeStamp });
    if (this.loose.size > 1) this.pinch(before, dx, dy);
    else if (point.does === 'blow') this.blow(event, dx, dy, elapsed);
    else if (point.does === 'pan') this.stage.camera.pan(dx, dy);
    else this.stage.camera.orbit(-dx * ORBIT_PER_PIXEL, dy * ORBIT_PER_PIXEL);
  }

  private up(event: PointerEvent, type: 'up' | 'cancel'): void {
    if (this.loose.delete(event.pointerId) && this.loose.size === 0) this.orbitEnd.now();
    if (!this.holding.delete(event.pointerId)) return;
    this.forward(type, event);
    this.canvas.classList.toggle('is-holding', this.holding.size > 0);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * PIXELS_PER_LINE : event.deltaY;
    this.stage.camera.zoom(Math.exp(-pixels * ZOOM_PER_PIXEL));
    if (this.loose.size === 0) this.orbitEnd.postpone();
  }

  /** Two fingers: their distance zooms, their common movement pans. */
  private pinch(before: number, dx: number, dy: number): void {
    const after = this.spread();
    if (before > 0 && after > 0) this.stage.camera.zoom(after / before);
    this.stage.camera.pan(dx / this.loose.size, dy / this.loose.size);
  }

  private blow(event: PointerEvent, dx: number, dy: number, elapsed: number): void {
    if (dx === 0 && dy === 0) return;
    const share = BLOW_MS / Math.max(elapsed, BLOW_MS / 2);
    this.stage.blow({ ...this.placeOf(event), dx: dx * share, dy: dy * share });
  }

  /** Distance between the first two pointers that grab nothing, in pixels; 0 for fewer than two. */
  private spread(): number {
    return spread([...this.loose.values()]);
  }

  private forward(type: 'down' | 'move' | 'up' | 'cancel', event: PointerEvent): 'rigid' | null {
    return this.stage.pointer({ type, id: event.pointerId, ...this.placeOf(event) });
  }

  /** Position in CSS pixels from the top left of the canvas. */
  private placeOf(event: PointerEvent): { x: number; y: number } {
    const box = this.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }
}

/** Detects the end of a camera gesture, so that the whole gesture is one undo step. */
export class GestureEnd {
  private readonly notify: () => void;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param notify called at the end of each gesture */
  constructor(notify: () => void) {
    this.notify = notify;
  }

  /** Restarts the timeout, for input without an end event. */
  postpone(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.now(), QUIET_MS);
  }

  /** Ends the gesture now. */
  now(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.notify();
  }
}
