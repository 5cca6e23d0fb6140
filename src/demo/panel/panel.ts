import { automaticColors, inPieces, nextTask } from '../../internal.ts';
import { groups, table, type Parameter, type AnyValues, type State } from '../../preset.ts';
import { create, iconButton, textButton } from '../ui/dom.ts';
import type { Editor } from '../editor/editor.ts';
import { icon } from '../ui/icons.ts';
import { createItems, type SceneLists } from './items.ts';
import { createRow, type Row } from './row.ts';
import { createSearch } from './search.ts';
import { SheetGrip } from './sheet.ts';
import { strings } from '../strings.ts';

export const PANEL_ID = 'parameters';

/** Elements below the rows of a group, by group key, at the top (`presets`) or at the `end`. */
type Feet = Readonly<Record<string, HTMLElement>>;

/** The parameter panel, created from the table in short tasks. */
export async function createPanel(
  editor: Editor,
  scene: SceneLists,
  feet: Feet,
  close: () => void,
): Promise<HTMLElement> {
  const rows = await inPieces(creatingRows(editor));
  await nextTask();
  const head = createHead(editor, close);
  const caption = create('p', { class: 'caption', 'aria-hidden': 'true' }, strings.panel.caption);
  const items = createItems(editor, scene);
  const scroll = create('div', { class: 'scroll' }, ...(feet.presets ? [feet.presets] : []));
  scroll.append(...createGroups(rows, feet), items.element, ...(feet.end ? [feet.end] : []));
  const panel = create('section', { id: PANEL_ID, class: 'panel card', 'aria-label': strings.panel.title });
  const search = createSearch(() => [...rows, ...items.rows()], scroll);
  panel.append(new SheetGrip(panel, close).element, head.element, search, scroll, caption);
  explainIn(caption, panel);
  const show = (state: State) => {
    head.show();
    const rig = { ...scene.rig, ...automaticColors(state.values) };
    const [values, base, scenes]: AnyValues[] = [state.values, editor.base, rig];
    items.show(state);
    for (const [{ key, default: initial }, row] of rows) {
      const own = scenes[key] ?? initial;
      row.show(values[key] ?? own, base[key] ?? own);
    }
  };
  editor.listen(show);
  show(editor.state);
  return panel;
}

function* creatingRows(editor: Editor): Generator<void, ReadonlyMap<Parameter, Row>, void> {
  const rows = new Map<Parameter, Row>();
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
