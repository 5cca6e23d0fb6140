import { type Values, findParameter } from '../../preset.ts';
import { DIRECTIONS, type Direction } from '../input/keyboard.ts';
import { create } from '../ui/dom.ts';
import type { Changes, Editor } from '../editor/editor.ts';
import { icon, type IconName } from '../ui/icons.ts';
import { strings } from '../strings.ts';

/** An object in the scene with a handle on the overlay. */
export interface Gizmo {
  /** Unique key, for gestures and tests. */
  readonly key: string;
  readonly icon: IconName;
  /** Accessible name with the current values. */
  describe(values: Values): string;
  /** Position of the handle in CSS pixels from the top left of the overlay; undefined when it is out of view. */
  place(values: Values): { x: number; y: number } | undefined;
  /** Changes for a move of the handle by CSS pixels to the right, up and towards the viewer. */
  move(from: Values, way: Direction): Changes;
  /** Acts on another key. @returns whether it has a use for that key */
  press?(key: string): boolean;
}

/** CSS pixels per press of an arrow key, without and with Shift. */
const NUDGE = 8;
const LEAP = 40;

/** Handle of a gizmo. It is dragged by pointer, or moved by arrow keys while focused. */
export class GizmoHandle {
  readonly element: HTMLButtonElement;
  private readonly gizmo: Gizmo;
  private readonly editor: Editor;
  private readonly valuesNow: () => Values;
  private held: { id: number; x: number; y: number; from: Values } | undefined;

  /** @param valuesNow current values, including the scene's values for optional parameters */
  constructor(gizmo: Gizmo, editor: Editor, valuesNow: () => Values) {
    this.gizmo = gizmo;
    this.editor = editor;
    this.valuesNow = valuesNow;
    const attributes = {
      type: 'button',
      class: 'gizmo',
      'data-gizmo': gizmo.key,
      'aria-description': strings.gizmos.how,
    };
    this.element = create('button', attributes, icon(gizmo.icon));
    this.listen();
  }

  show(): void {
    const values = this.valuesNow();
    const place = this.gizmo.place(values);
    this.element.hidden = place === undefined;
    if (place) this.element.style.translate = `${place.x.toFixed(1)}px ${place.y.toFixed(1)}px`;
    const name = this.gizmo.describe(values);
    if (this.element.title === name) return;
    this.element.title = name;
    this.element.setAttribute('aria-label', name);
  }

  private listen(): void {
    const { element } = this;
    element.addEventListener('pointerdown', (event) => this.grab(event));
    element.addEventListener('pointermove', (event) => this.drag(event));
    element.addEventListener('pointerup', (event) => this.release(event));
    element.addEventListener('pointercancel', (event) => this.release(event));
    element.addEventListener('keydown', (event) => this.press(event));
    element.addEventListener('keyup', () => this.editor.settle());
    element.addEventListener('blur', () => this.editor.settle());
  }

  private grab(event: PointerEvent): void {
    if (event.button !== 0 || this.held) return;
    this.element.setPointerCapture(event.pointerId);
    this.held = { id: event.pointerId, x: event.clientX, y: event.clientY, from: this.valuesNow() };
  }

  /** Moves from the position at the start of the drag, so that rounding and clamping errors do not accumulate. */
  private drag(event: PointerEvent): void {
    if (event.pointerId !== this.held?.id) return;
    const { x, y, from } = this.held;
    this.apply(from, [event.clientX - x, y - event.clientY, 0]);
  }

  private release(event: PointerEvent): void {
    if (event.pointerId !== this.held?.id) return;
    this.held = undefined;
    this.editor.settle();
  }

  private press(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const way = DIRECTIONS[event.key];
    if (!way && !this.gizmo.press?.(event.key)) return;
    event.preventDefault();
    // The page uses the arrow keys to move the ball.
    event.stopPropagation();
    if (!way) return;
    const pixels = event.shiftKey ? LEAP : NUDGE;
    this.apply(this.valuesNow(), [pixels * way[0], pixels * way[1], pixels * way[2]]);
  }

  private apply(from: Values, way: Direction): void {
    this.editor.changeAll(this.gizmo.move(from, way), `gizmo ${this.gizmo.key}`);
  }
}

/** Rounds a value and clamps it to the parameter's range. Values from pixel positions need only a few decimals. */
export function clampTo(key: string, value: number, decimals: number): number {
  const row = findParameter(key);
  if (row?.kind !== 'number') return value;
  const rounded = Number(value.toFixed(decimals));
  // Adding 0 converts -0 to 0, as a link does.
  return Math.min(Math.max(rounded, row.min), row.max) + 0;
}
