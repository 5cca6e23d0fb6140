import { automaticColors, inPieces, nextTask } from '../../internal.ts';
import { groups, table, type Parameter, type AnyValues, type State } from '../../preset.ts';
import { create, iconButton, textButton } from '../ui/dom.ts';
import type { Editor } from '../editor/editor.ts';
import { icon } from '../ui/icons.ts';
import { createDial, hourParameter } from './dial.ts';
import { createItems, type SceneLists } from './items.ts';
import { createRow, type Row } from './row.ts';
import { createSearch } from './search.ts';
import { strings } from '../strings.ts';

export const PANEL_ID = 'parameters';

/** Elements below the rows of a group, by group key, at the top (`presets`), above the items (`model`) or at the `end`. */
type Feet = Readonly<Record<string, HTMLElement>>;

/** The parameter panel, created from the table in short tasks. */
export async function createPanel(
  editor: Editor,
  scene: SceneLists,
  feet: Feet,
  close: () => void,
): Promise<HTMLElement> {
  const rows = await inPieces(creatingRows(editor, scene));
  await nextTask();
  const head = createHead(editor, close);
  const caption = create('p', { class: 'caption', 'aria-hidden': 'true' }, strings.panel.caption);
  const items = createItems(editor, scene);
  const scroll = create('div', { class: 'scroll' }, ...(feet.presets ? [feet.presets] : []));
  scroll.append(...createGroups(rows, feet), feet.model, items.element, feet.end);
  const panel = create('section', { id: PANEL_ID, class: 'panel card', 'aria-label': strings.panel.title });
  const search = createSearch(() => [...rows, ...items.rows()], scroll);
  panel.append(new SheetGrip(panel, close).element, head.element, search, scroll, caption);
  explainIn(caption, panel);
  const show = (state: State) => {
    head.show();
    showRows(state, () => true);
  };
  const showRows = (state: State, isShown: (key: string) => boolean) => {
    const rig = { ...scene.rig, ...automaticColors(state.values) };
    const [values, base, scenes]: AnyValues[] = [editor.shown, editor.base, rig];
    items.show(state);
    for (const [{ key, default: initial }, row] of rows) {
      if (!isShown(key)) continue;
      const own = scenes[key] ?? initial;
      row.show(values[key] ?? own, base[key] ?? own);
    }
  };
  editor.listen(show);
  editor.listenToAnimation((changed) => showRows(editor.state, (key) => key in changed));
  show(editor.state);
  return panel;
}

function* creatingRows(editor: Editor, scene: SceneLists): Generator<void, ReadonlyMap<Parameter, Row>, void> {
  const rows = new Map<Parameter, Row>([[hourParameter, createDial(editor, scene)]]);
  for (const parameter of table.filter((each) => hasChoice(each) && isOfPanel(each))) {
    rows.set(parameter, createRow(parameter, editor));
    yield;
  }
  return rows;
}

/** A choice with a single option is omitted from the panel. */
function hasChoice(parameter: Parameter): boolean {
  return parameter.kind !== 'choice' || parameter.options.length > 1;
}

/** List items are added to the panel separately. */
function isOfPanel({ group }: Parameter): boolean {
  return groups.some(({ key }) => key === group);
}

function createGroups(rows: ReadonlyMap<Parameter, Row>, feet: Feet): HTMLElement[] {
  return groups.map(({ key, label, advanced }) => {
    const elements = [...rows].flatMap(([{ group }, row]) => (group === key ? [row.element] : []));
    const summary = create('summary', {}, label);
    const foot = feet[key] ? [feet[key]] : [];
    return create('details', { class: 'group', open: !advanced }, summary, ...elements, ...foot);
  });
}

function createHead(editor: Editor, close: () => void): { element: HTMLElement; show(): void } {
  const { title, undo, redo, resetAll, close: closeName } = strings.panel;
  const undoButton = iconButton('icon-button', undo, icon('undo'), () => editor.undo());
  const redoButton = iconButton('icon-button', redo, icon('redo'), () => editor.redo());
  const resetButton = textButton('quiet', resetAll, () => editor.resetAll());
  const closeButton = iconButton('icon-button close', closeName, icon('close'), close);
  const heading = create('h2', {}, title);
  return {
    element: create('header', { class: 'panel-head' }, heading, undoButton, redoButton, resetButton, closeButton),
    show() {
      undoButton.disabled = !editor.canUndo;
      redoButton.disabled = !editor.canRedo;
    },
  };
}

/** Shows the description of the row under the pointer or the focus. Screen readers get the same text from the row. */
function explainIn(caption: HTMLElement, panel: HTMLElement): void {
  const explain = ({ target }: Event) => {
    const row = target instanceof Element ? target.closest<HTMLElement>('[data-text]') : null;
    if (row) caption.textContent = row.dataset.text!;
  };
  panel.addEventListener('pointerover', explain);
  panel.addEventListener('focusin', explain);
}

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
class SheetGrip {
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
