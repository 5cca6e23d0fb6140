import type { Stage } from '../../index.ts';
import { itemLabel, LIST_LIMIT, startValues, writePath } from '../../internal.ts';
import type { AnyValues, Values } from '../../preset.ts';
import type { Changes, Editor } from '../editor/editor.ts';
import { FlowBrush } from '../flows/flowBrush.ts';
import { flowIn, inserted, lineOf, moved, placeOf, pointAt, removed } from '../flows/flowPoints.ts';
import type { DrawnFlow } from '../flows/stroke.ts';
import type { Direction } from '../input/keyboard.ts';
import { strings } from '../strings.ts';
import { create, createSvg, textButton } from '../ui/dom.ts';
import { GizmoHandle, type Gizmo } from './gizmo.ts';

/** Radius of a drawn flow, CSS pixels. */
const RADIUS = 44;
/** Seconds that smoke takes along a drawn flow. */
const DURATION = 2.5;
const INDICES = Array.from({ length: LIST_LIMIT }, (_, index) => index);

/** What flow gizmos need of the overlay. */
interface Overlay {
  readonly editor: Editor;
  readonly stage: Stage;
  values(): Values;
  /** Of the canvas from the overlay, CSS pixels. */
  offset(): { x: number; y: number };
  /** Shows the handles. */
  reveal(): void;
}

/** Draws flows into the picture, and gives each of their points a handle. */
export class FlowGizmos {
  /** Holds the handles. */
  readonly element = create('div', { class: 'flow-points' });
  readonly brush: FlowBrush;
  readonly button: HTMLButtonElement;
  readonly line = createSvg('path', { class: 'gizmo-flow' });
  private readonly overlay: Overlay;
  private readonly handles = new Map<string, GizmoHandle>();
  /** The flow that the next stroke is for; undefined for a new one. */
  private wanted: number | undefined;
  private opener: HTMLElement | undefined;

  constructor(overlay: Overlay) {
    this.overlay = overlay;
    this.button = textButton('quiet', strings.flow.draw, () => this.draw(undefined, this.button));
    this.brush = new FlowBrush(
      overlay.stage,
      (flow) => this.add(flow),
      () => this.opener?.focus(),
    );
  }

  /**
   * Lets the user draw a stroke.
   * @param index of the flow that it is for; a new one without it
   * @param opener gets the focus if nothing is drawn
   */
  draw(index: number | undefined, opener: HTMLElement): void {
    this.wanted = index;
    this.opener = opener;
    this.brush.open();
  }

  show(): void {
    const values = this.overlay.values();
    const present = INDICES.map((index) => `flows.${index}`).filter((item) => isPresent(item, values));
    this.button.disabled = present.length === LIST_LIMIT;
    const shown = new Set(present.flatMap((item) => this.showPoints(item, values)));
    for (const [key, { element }] of this.handles) if (!shown.has(key)) element.hidden = true;
    this.line.setAttribute('d', present.map((item) => this.lineIn(item, values)).join(''));
  }

  /** @returns the keys of its handles */
  private showPoints(item: string, values: AnyValues): string[] {
    return flowIn(values, item).points.map((_, index) => {
      const key = `${item}.points.${index}`;
      let handle = this.handles.get(key);
      if (!handle) {
        const { editor } = this.overlay;
        const gizmo = new FlowPointGizmo(item, index, this.overlay, (at) => this.focus(item, at));
        this.handles.set(key, (handle = new GizmoHandle(gizmo, editor, () => this.overlay.values())));
        this.element.append(handle.element);
      }
      handle.show();
      return key;
    });
  }

  private lineIn(item: string, values: AnyValues): string {
    const flow = flowIn(values, item);
    const { x: left, y: top } = this.overlay.offset();
    const { sight } = this.overlay.stage;
    const places = lineOf(flow).flatMap((place) => sight.project(place, flow.carrier) ?? []);
    return `M${places.map(({ x, y }) => `${(x + left).toFixed(1)} ${(y + top).toFixed(1)}`).join('L')}`;
  }

  private add({ points, isClosed, metres, length }: DrawnFlow): void {
    const { editor, stage } = this.overlay;
    const values = this.overlay.values();
    const index = this.wanted ?? INDICES.find((each) => !isPresent(`flows.${each}`, values));
    if (index === undefined) return;
    const item = `flows.${index}`;
    const rounded = (value: number, min: number, max: number) => Math.min(Math.max(Number(value.toFixed(2)), min), max);
    const isNew = this.wanted === undefined;
    const flow = { ...flowIn(values, item), ...(isNew && { position: [0, 0, 0] as const, scale: 1, carrier: -1 }) };
    const own = points.map((point) => pointAt(flow, stage.sight.change(point, -1, flow.carrier)));
    editor.changeAll({
      ...(isNew && {
        ...startValues('flows', index),
        [`${item}.radius`]: rounded(RADIUS * metres, 0.02, 50),
        [`${item}.speed`]: rounded(length / DURATION, 0.1, 50),
      }),
      [`${item}.points`]: writePath(own),
      [`${item}.closed`]: isClosed ? 'ring' : 'open',
    });
    this.overlay.reveal();
    this.focus(item, 0);
  }

  private focus(item: string, index: number): void {
    this.show();
    this.handles.get(`${item}.points.${index}`)?.element.focus();
  }
}

/** A flow exists when any of its values is set. */
function isPresent(item: string, values: AnyValues): boolean {
  return Object.keys(values).some((key) => key.startsWith(`${item}.`));
}

/** Handle of a point of a flow. */
class FlowPointGizmo implements Gizmo {
  readonly key: string;
  readonly icon = 'keyframe';
  private readonly item: string;
  private readonly index: number;
  private readonly overlay: Overlay;
  private readonly focus: (index: number) => void;

  /** @param focus gives the focus to the handle of another point */
  constructor(item: string, index: number, overlay: Overlay, focus: (index: number) => void) {
    this.key = `${item}.points.${index}`;
    this.item = item;
    this.index = index;
    this.overlay = overlay;
    this.focus = focus;
  }

  describe(values: AnyValues): string {
    const label = itemLabel('flows', Number(this.item.split('.')[1]));
    return strings.flow.point(label, this.index + 1, flowIn(values, this.item).points.length);
  }

  place(values: AnyValues): { x: number; y: number } | undefined {
    const flow = flowIn(values, this.item);
    const point = flow.points.at(this.index);
    const seen = point && this.overlay.stage.sight.project(placeOf(flow, point), flow.carrier);
    const { x, y } = this.overlay.offset();
    return seen && { x: seen.x + x, y: seen.y + y };
  }

  move(from: AnyValues, way: Direction): Changes {
    const flow = flowIn(from, this.item);
    const place = this.overlay.stage.sight.shift(placeOf(flow, flow.points[this.index]), way, flow.carrier);
    return { [`${this.item}.points`]: moved(flow, this.index, pointAt(flow, place)) };
  }

  /** Delete removes the point, Enter adds one after it. */
  press(key: string): boolean {
    const flow = flowIn(this.overlay.values(), this.item);
    const change = (text: string, index: number): true => {
      this.overlay.editor.changeAll({ [`${this.item}.points`]: text });
      this.focus(index);
      return true;
    };
    if (key === 'Delete' || key === 'Backspace') {
      const text = removed(flow, this.index);
      return text === undefined || change(text, Math.min(this.index, flow.points.length - 2));
    }
    if (key !== 'Enter' && key !== 'Insert') return false;
    const added = inserted(flow, this.index);
    return !added || change(added.text, added.at);
  }
}
