import type { Model, ModelNode, ModelOptions, ModelPoint, Stage } from '../../index.ts';
import { itemLabel, LIST_LIMIT } from '../../internal.ts';
import type { ChoiceParameter, ModelFile, NumberParameter, Value } from '../../preset.ts';
import type { Editor } from '../editor/editor.ts';
import { createControl } from '../panel/control.ts';
import { frameRow, type Row } from '../panel/row.ts';
import { strings } from '../strings.ts';
import { create, textButton, uniqueId } from '../ui/dom.ts';
import type { Notices } from '../ui/notices.ts';

const words = strings.model;
type Name = keyof typeof words.rows;

/** Range, step and default of the number of a row. */
const NUMBERS: Readonly<Partial<Record<Name, readonly [min: number, max: number, step: number, initial: number]>>> = {
  x: [-1000, 1000, 0.05, 0],
  y: [-1000, 1000, 0.05, 0],
  z: [-1000, 1000, 0.05, 0],
  turn: [-360, 360, 1, 0],
  size: [0.01, 100, 0.05, 1],
  speed: [0, 10, 0.05, 1],
};
/** Movement of a click in CSS pixels. */
const CLICK_PIXELS = 6;
/** Sizes of an emitter and of its puffs as shares of the longest side of the model, and the limits of the latter in metres. */
const [RADIUS, PUFF, PUFF_LIMITS] = [0.03, 0.12, [0.03, 0.6]] as const;
/** Particles per second where the scene has none. */
const RATE = 40;

/** What the section of models acts on. */
export interface ModelParts {
  readonly editor: Editor;
  readonly stage: Stage;
  /** The stage's canvas. */
  readonly canvas: HTMLCanvasElement;
  readonly notices: Notices;
}

/** The place of a model, what it does, and where it smokes: rows of the panel, and clicks on the picture. */
export class ModelRows {
  readonly element = create('div', {});
  private readonly parts: ModelParts;
  private readonly rows = create('div', {});
  private readonly nodes = create('select', { 'aria-label': words.node });
  private readonly clicks = create('input', { id: uniqueId(), type: 'checkbox', role: 'switch', checked: true });
  private shown: { readonly file: ModelFile; readonly model: Model } | undefined;
  private values: { readonly row: Row; readonly value: (options: ModelOptions) => Value }[] = [];

  constructor(parts: ModelParts) {
    this.parts = parts;
    const add = textButton('quiet', words.add, () => this.addToNode());
    const clicks = create('div', { class: 'debug-panel-row' }, create('label', { for: this.clicks.id }, words.clicks));
    clicks.append(this.clicks);
    this.clicks.addEventListener('change', () => this.showCursor());
    this.element.append(this.rows, clicks, create('div', { class: 'adder' }, this.nodes, add));
    this.listenToClicks();
  }

  /** @param model what the file contains */
  show(file: ModelFile, model: Model): void {
    if (this.shown?.model === model && this.shown.file === file) return;
    const before = this.shown;
    this.shown = { file, model };
    if (before?.file.bytes !== file.bytes) this.build(model);
    for (const { row, value } of this.values) row.show(value(file.options), value(file.options));
    const chosen = this.nodes.selectedIndex;
    this.nodes.replaceChildren(...model.nodes.map(({ name }) => create('option', {}, name)));
    if (before?.file.bytes === file.bytes) this.nodes.selectedIndex = chosen;
    this.showCursor();
  }

  hide(): void {
    this.shown = undefined;
    this.showCursor();
  }

  private build({ animations }: Model): void {
    const place = ({ position }: ModelOptions) => position ?? { x: 0, y: 0, z: 0 };
    this.values = [
      ...(['x', 'y', 'z'] as const).map((axis) => ({
        row: this.number(axis, (value) => ({ position: { ...place(this.options), [axis]: value } })),
        value: (options: ModelOptions) => place(options)[axis],
      })),
      {
        row: this.number('turn', (degrees) => ({ turn: (degrees * Math.PI) / 180 })),
        value: ({ turn = 0 }) => Number(((turn * 180) / Math.PI).toFixed(3)),
      },
      { row: this.number('size', (size) => ({ size })), value: ({ size = 1 }) => size },
    ];
    if (animations.length > 0) {
      const names = animations.map(({ name }) => name);
      this.values.push(
        { row: this.choice(names), value: ({ animation = names[0] }) => animation },
        { row: this.number('speed', (speed) => ({ speed })), value: ({ speed = 1 }) => speed },
      );
    }
    this.rows.replaceChildren(...this.values.map(({ row }) => row.element));
  }

  private get options(): ModelOptions {
    return this.shown?.file.options ?? {};
  }

  private number(name: Name, change: (value: number) => ModelOptions): Row {
    const [min, max, step, initial] = NUMBERS[name]!;
    const [label, text, unit] = words.rows[name];
    const range = { min, max, step, default: initial, slider: max > 100 ? 'fine' : 'even', unit } as const;
    const parameter: NumberParameter = { ...OF_ROWS, key: `model.${name}`, kind: 'number', label, text, ...range };
    return this.row(parameter, (value) => change(Number(value)));
  }

  private choice(names: readonly string[]): Row {
    const options = [...names.map((name) => ({ value: name, label: name })), { value: '', label: words.noAnimation }];
    const [label, text] = words.rows.animation;
    const parameter: ChoiceParameter = {
      ...OF_ROWS,
      key: 'model.animation',
      kind: 'choice',
      label,
      text,
      options,
      default: '',
    };
    return this.row(parameter, (value) => ({ animation: String(value) }));
  }

  /** A row whose change is applied at the end of a gesture, because the model is read again. */
  private row(parameter: NumberParameter | ChoiceParameter, change: (value: Value) => ModelOptions): Row {
    const textId = uniqueId();
    let waiting: Value | undefined;
    const listener = {
      change: (value: Value) => control.show((waiting = value)),
      settle: () => {
        if (waiting !== undefined) void this.setOptions(change(waiting));
        waiting = undefined;
      },
    };
    const control = createControl(parameter, textId, listener, () => ({}));
    return frameRow(parameter, textId, control, () => undefined);
  }

  private async setOptions(change: ModelOptions): Promise<void> {
    const { editor, notices } = this.parts;
    if (!this.shown) return;
    try {
      await editor.setModel({ ...this.shown.file, options: { ...this.options, ...change } });
    } catch (error) {
      notices.notify((error as Error).message);
    }
  }

  private listenToClicks(): void {
    const { canvas, stage } = this.parts;
    let pressed: { readonly x: number; readonly y: number } | undefined;
    canvas.addEventListener('pointerdown', (event) => {
      const isPlain = event.isPrimary && event.button === 0 && !event.altKey && !event.shiftKey;
      pressed = isPlain ? { x: event.offsetX, y: event.offsetY } : undefined;
    });
    // Before the pointer lets go of what it holds.
    canvas.addEventListener('pointerup', () => canvas.classList.contains('is-holding') && (pressed = undefined), {
      capture: true,
    });
    canvas.addEventListener('click', ({ offsetX: x, offsetY: y, detail }) => {
      const isStill = pressed && Math.hypot(x - pressed.x, y - pressed.y) < CLICK_PIXELS;
      // The second click of a double click drops an object.
      if (!this.shown || !this.clicks.checked || !isStill || detail > 1) return;
      const point = stage.pickModel(x, y);
      if (point) this.addToPoint(point);
    });
  }

  private showCursor(): void {
    this.parts.canvas.classList.toggle('is-picking', this.shown !== undefined && this.clicks.checked);
  }

  private addToPoint({ node, position, direction }: ModelPoint): void {
    const radius = RADIUS * Math.max(...this.shown!.model.box);
    this.add(node, { shape: 'disc', radius: rounded(radius), ...vector('position', position), ...vector('direction', direction) }); // prettier-ignore
  }

  /** Smoke from the whole surface of a node, or from its origin. */
  private addToNode(): void {
    const node = this.shown?.model.nodes[this.nodes.selectedIndex];
    if (!node) return;
    const { surface } = node;
    this.add(node, surface < 0 ? { shape: 'point' } : { shape: 'surface', surface });
  }

  /** Adds an emitter to a node. Its share is the largest one, so that it smokes as much as others. */
  private add({ name, rigid }: ModelNode, own: Readonly<Record<string, Value>>): void {
    const { editor, notices, stage } = this.parts;
    const values = { ...stage.rig, ...editor.state.values } as Readonly<Record<string, Value | undefined>>;
    const index = Array.from({ length: LIST_LIMIT }, (_, at) => at).find((at) => !isUsed(at, values));
    if (index === undefined) return notices.notify(words.full(LIST_LIMIT));
    const shares = Object.keys(values).flatMap((key) =>
      /^emitters\.\d\.share$/.test(key) ? [Number(values[key])] : [],
    );
    const puff = Math.min(Math.max(PUFF * Math.max(...this.shown!.model.box), PUFF_LIMITS[0]), PUFF_LIMITS[1]);
    const all = { rigid, size: rounded(puff), share: Math.max(1, ...shares), inherit: 0.3, ...AT_ORIGIN, ...own };
    const needsRate = Number(values['emission.rate']) === 0;
    editor.changeAll({
      ...Object.fromEntries(Object.entries(all).map(([key, value]) => [`emitters.${index}.${key}`, value])),
      ...(needsRate && { 'emission.rate': RATE }),
    });
    notices.mention(words.added(name, itemLabel('emitters', index)));
  }
}

/** Whether an emitter of the scene or the user emits: by the rate, by the way it travels, or at times. */
function isUsed(index: number, values: Readonly<Record<string, Value | undefined>>): boolean {
  const key = `emitters.${index}.`;
  if (!Object.keys(values).some((name) => name.startsWith(key))) return false;
  const timeline = String(values.timeline ?? '');
  const isTimed = timeline.includes(key) || new RegExp(`;burst[^;]*/\\d+\\*${index}\\*`).test(timeline);
  const { [`${key}share`]: share = 1, [`${key}perMetre`]: perMetre = 0, [`${key}burst.count`]: count = 0 } = values;
  return isTimed || [share, perMetre, count].some((amount) => Number(amount) > 0);
}

/** Rows of models are no parameters of links. */
const OF_ROWS = { group: 'model', reader: 'stage' } as const;

/** Upwards from the origin of the node: scenes have emitters without a share elsewhere. */
const AT_ORIGIN = { ...vector('position', [0, 0, 0]), ...vector('direction', [0, 1, 0]) };

function vector(name: string, [x, y, z]: readonly number[]): Record<string, number> {
  return { [`${name}.x`]: rounded(x), [`${name}.y`]: rounded(y), [`${name}.z`]: rounded(z) };
}

function rounded(value: number): number {
  return Number(value.toFixed(4));
}
