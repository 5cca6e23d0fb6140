import type { Stage } from '../../index.ts';
import { LIST_LIMIT, startValues } from '../../internal.ts';
import type { AnyValues, Values } from '../../preset.ts';
import { create, createSvg, textButton } from '../ui/dom.ts';
import type { Editor } from '../editor/editor.ts';
import { FlowGizmos } from './flowGizmos.ts';
import { GizmoHandle, type Gizmo } from './gizmo.ts';
import { PlaceGizmo } from './placeGizmo.ts';
import { strings } from '../strings.ts';
import { SunGizmo } from './sunGizmo.ts';
import { WindGizmo } from './windGizmo.ts';
import { areSame, carrierChoices, type CarrierChoice } from '../panel/items.ts';

const INDICES = Array.from({ length: LIST_LIMIT }, (_, index) => index);

/** Handles over the smoke: sun, wind, emitters, vortices and the points of flows. */
export class Gizmos {
  readonly element: HTMLElement;
  private readonly editor: Editor;
  private readonly stage: Stage;
  private readonly arc = createSvg('path', { class: 'gizmo-arc' });
  private readonly arrow = createSvg('path', { class: 'gizmo-arrow' });
  private readonly sun = new SunGizmo(() => ({ ...this.size(), azimuth: this.stage.camera.azimuth() }));
  private readonly wind = new WindGizmo(
    () => this.stage.sight,
    () => this.size(),
  );
  private readonly places: readonly PlaceGizmo[];
  private readonly handles: ReadonlyMap<Gizmo, GizmoHandle>;
  private readonly riding: Riding;
  private readonly flows: FlowGizmos;
  private readonly reveal: () => void;

  /** @param reveal shows the handles */
  constructor(editor: Editor, stage: Stage, reveal: () => void) {
    this.reveal = reveal;
    this.editor = editor;
    this.stage = stage;
    this.places = (['emitters', 'vortices'] as const).flatMap((list) =>
      INDICES.map((index) => this.placeOf(list, index)),
    );
    const gizmos: readonly Gizmo[] = [this.sun, this.wind, ...this.places];
    this.handles = new Map(gizmos.map((gizmo) => [gizmo, new GizmoHandle(gizmo, editor, () => this.values)]));
    this.riding = new Riding(editor, stage, () => this.values);
    this.flows = new FlowGizmos({
      editor,
      stage,
      values: () => this.values,
      offset: () => this.offset(),
      reveal: () => this.element.hidden && this.reveal(),
    });
    const lines = [this.flows.line, this.arc, this.arrow];
    const drawing = createSvg('svg', { class: 'gizmo-lines', 'aria-hidden': 'true' }, ...lines);
    const addWhirl = textButton('quiet', strings.gizmos.addWhirl, () => this.addWhirl());
    const tools = create('div', { class: 'gizmo-tools card' }, addWhirl, this.flows.button, this.riding.element);
    this.element = create('div', { class: 'gizmos', role: 'group', 'aria-label': strings.gizmos.title, hidden: true });
    this.element.append(
      drawing,
      ...[...this.handles.values()].map(({ element }) => element),
      this.flows.element,
      tools,
    );
    this.listen();
  }

  /** Shows or hides the handles. @returns whether they are shown now */
  toggle(): boolean {
    this.element.hidden = !this.element.hidden;
    this.show();
    return !this.element.hidden;
  }

  /** Lies over the picture while a flow is drawn. */
  get brush(): HTMLElement {
    return this.flows.brush.element;
  }

  /** Lets the user draw the stroke of a flow. @param opener gets the focus if nothing is drawn */
  drawFlow(index: number, opener: HTMLElement): void {
    this.flows.draw(index, opener);
  }

  private listen(): void {
    this.editor.listen(() => this.show());
    this.stage.on('frame', () => this.show());
    for (const place of this.places) {
      this.handles.get(place)!.element.addEventListener('focus', () => this.riding.choose(place));
    }
  }

  private show(): void {
    if (this.element.hidden) return;
    const { values } = this;
    for (const [gizmo, handle] of this.handles) {
      if (gizmo instanceof PlaceGizmo && !isPresent(gizmo.key, values)) handle.element.hidden = true;
      else handle.show();
    }
    this.arc.setAttribute('d', this.sun.arc(values));
    const [from, to] = [this.wind.begin, this.wind.place(values)];
    this.arrow.setAttribute('d', `M${from.x} ${from.y}L${to.x} ${to.y}`);
    this.riding.show();
    this.flows.show();
  }

  private get values(): Values {
    return { ...this.stage.rig, ...this.editor.shown };
  }

  private size(): { width: number; height: number } {
    return { width: this.element.clientWidth, height: this.element.clientHeight };
  }

  private placeOf(list: 'emitters' | 'vortices', index: number): PlaceGizmo {
    return new PlaceGizmo(
      list,
      index,
      () => this.stage.sight,
      () => this.offset(),
    );
  }

  private offset(): { x: number; y: number } {
    const [picture, overlay] = [this.stage.canvas as HTMLCanvasElement, this.element].map((element) =>
      element.getBoundingClientRect(),
    );
    return { x: picture.left - overlay.left, y: picture.top - overlay.top };
  }

  /** Adds a vortex at the camera's target, with its axis along the line of sight. */
  private addWhirl(): void {
    const free = INDICES.find((index) => !isPresent(`vortices.${index}`, this.values));
    if (free === undefined) return;
    const gizmo = this.places.find(({ key }) => key === `vortices.${free}`)!;
    const [x, y, z] = this.stage.sight.centre.map((metres) => Number(metres.toFixed(3)));
    const place = { [`${gizmo.key}.position.x`]: x, [`${gizmo.key}.position.y`]: y, [`${gizmo.key}.position.z`]: z };
    this.editor.changeAll({ ...startValues('vortices', free), ...place });
    this.show();
    this.handles.get(gizmo)!.element.focus();
  }
}

/** A vortex exists when its circulation is not 0; an emitter exists when any of its values is set. */
function isPresent(key: string, values: AnyValues): boolean {
  if (key.startsWith('vortices')) return Number(values[`${key}.circulation`] ?? 0) !== 0;
  return Object.keys(values).some((name) => name.startsWith(`${key}.`));
}

/**
 * Attaches the emitter or vortex that was dragged last to an object of the scene. It keeps its position and then
 * follows the object.
 */
class Riding {
  readonly element: HTMLElement;
  private readonly stage: Stage;
  private readonly valuesNow: () => Values;
  private readonly name = create('span');
  private readonly select = create('select');
  private chosen: PlaceGizmo | undefined;
  private offered: readonly CarrierChoice[] = [];

  constructor(editor: Editor, stage: Stage, valuesNow: () => Values) {
    this.stage = stage;
    this.valuesNow = valuesNow;
    this.element = create('label', { class: 'riding', hidden: true }, this.name, this.select);
    this.select.addEventListener('change', () => {
      if (this.chosen) editor.changeAll(this.chosen.ride(this.valuesNow(), Number(this.select.value)));
    });
  }

  choose(gizmo: PlaceGizmo): void {
    this.chosen = gizmo;
    this.show();
  }

  show(): void {
    const choices = carrierChoices(this.stage);
    this.element.hidden = !this.chosen || choices.length === 1;
    if (!this.chosen) return;
    if (!areSame(this.offered, choices)) {
      this.select.replaceChildren(...choices.map(({ value, label }) => create('option', { value: `${value}` }, label)));
      this.offered = choices;
    }
    this.name.textContent = strings.gizmos.attachTo(this.chosen.describe());
    this.select.value = `${this.chosen.carrierIn(this.valuesNow())}`;
  }
}
