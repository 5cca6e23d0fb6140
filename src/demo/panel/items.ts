import { listLabel, listNames, startValues, FIRST_PART } from '../../internal.ts';
import {
  findParameter,
  itemGroups,
  table,
  type ChoiceParameter,
  type Parameter,
  type State,
  type AnyValues,
  type Value,
  type Values,
} from '../../preset.ts';
import { create, textButton } from '../ui/dom.ts';
import type { Editor } from '../editor/editor.ts';
import { createRow, type Row } from './row.ts';
import { strings } from '../strings.ts';

/** Carriers and default values of the current scene's lists. */
export interface SceneLists extends CarrierNames {
  /** The scene's values for optional parameters, in effect where none is set. */
  readonly rig: Values;
}

/** A section of the panel. */
export interface Section {
  readonly element: HTMLElement;
  show(state: State): void;
}

interface Item {
  readonly element: HTMLDetailsElement;
  show(): void;
  /** The rows that exist so far. */
  rows(): ReadonlyMap<Parameter, Row>;
}

export interface Items extends Section {
  /** Rows of all items that exist so far. */
  rows(): (readonly [Parameter, Row])[];
}

/** Emitters, vortices and the other lists: the items that the scene or the user has set, and a control to add more. */
export function createItems(editor: Editor, scene: SceneLists): Items {
  const items = new Map<string, Item>();
  const holder = create('div', { class: 'items' });
  const reveal = (key: string) => {
    const added = items.get(key)!;
    added.rows();
    added.element.open = true;
    added.element.scrollIntoView();
  };
  const element = create('div', {}, createAdder(editor, scene, reveal), holder);
  let offered = carrierChoices(scene);
  const show = (state: State) => {
    const choices = carrierChoices(scene);
    if (!areSame(offered, choices)) {
      items.clear();
      holder.replaceChildren();
      offered = choices;
    }
    const present = itemsOf({ ...scene.rig, ...state.values });
    for (const [key, item] of items) item.element.hidden = !present.has(key);
    for (const { key, label } of itemGroups) {
      if (!present.has(key)) continue;
      if (!items.has(key)) {
        items.set(key, createItem(key, label, editor, scene));
        holder.append(items.get(key)!.element);
      }
      items.get(key)!.show();
    }
  };
  const rows = () => [...items.values()].flatMap((item) => (item.element.hidden ? [] : [...item.rows()]));
  return { element, show, rows };
}

/** Group keys, such as `vortices.0`, of the items that have a value. */
function itemsOf(values: Values): ReadonlySet<string> {
  return new Set(Object.keys(values).flatMap((key) => findParameter(key)?.group ?? []));
}

/** Control that adds the first unused item of a list. @param reveal called with the group of the new item */
function createAdder(editor: Editor, scene: SceneLists, reveal: (group: string) => void): HTMLElement {
  const options = listNames.map((list) => create('option', { value: list }, listLabel(list)));
  const select = create('select', { 'aria-label': strings.items.kind }, ...options);
  const button = textButton('quiet', strings.items.add, () => {
    const present = itemsOf({ ...scene.rig, ...editor.state.values });
    const free = itemGroups.find(({ list, key }) => list === select.value && !present.has(key));
    if (!free) return;
    editor.changeAll(startValues(free.list, Number(free.key.split('.')[1])));
    reveal(free.key);
  });
  return create('div', { class: 'adder' }, select, button);
}

/** One item. Its rows are created when it is opened or searched, because there may be dozens of items. */
function createItem(group: string, label: string, editor: Editor, scene: SceneLists): Item {
  const rows = new Map<Parameter, Row>();
  const remove = textButton('quiet', strings.items.remove(label), () => editor.changeAll(removal(group, editor)));
  const foot = create('div', { class: 'item-foot' }, remove);
  const element = create('details', { class: 'group' }, create('summary', {}, label));
  const show = () => {
    remove.hidden = !canBeRemoved(group, editor, scene);
    const [values, base, rig]: AnyValues[] = [editor.shown, editor.base, scene.rig];
    for (const [parameter, row] of rows) {
      const scenes = rig[parameter.key] ?? parameter.default;
      row.show(values[parameter.key] ?? scenes, base[parameter.key] ?? scenes);
    }
  };
  const make = () => {
    if (rows.size > 0) return rows;
    for (const parameter of table.filter((row) => row.group === group)) {
      const row = createRow(riding(parameter, scene), editor);
      rows.set(parameter, row);
      element.append(row.element);
    }
    element.append(foot);
    show();
    return rows;
  };
  element.addEventListener('toggle', () => {
    if (element.open) make();
  });
  return { element, show, rows: make };
}

/** Replaces the integer parameter for a carrier by a choice with the carriers' names. */
function riding(parameter: Parameter, scene: SceneLists): Parameter {
  if (parameter.kind !== 'integer' || !parameter.key.endsWith('.rigid')) return parameter;
  const { key, group, label, text, reader } = parameter;
  const options = carrierChoices(scene);
  return { kind: 'choice', key, group, label, text, reader, options, default: -1 } satisfies ChoiceParameter;
}

/** Items of the scene or the preset can be changed but not removed. */
function canBeRemoved(group: string, editor: Editor, scene: SceneLists): boolean {
  return !itemsOf({ ...scene.rig, ...editor.base }).has(group);
}

function removal(group: string, editor: Editor): Record<string, Value | undefined> {
  const keys = Object.keys(editor.state.values).filter((key) => findParameter(key)?.group === group);
  return Object.fromEntries(keys.map((key) => [key, undefined]));
}

/** Names of a scene's carriers, by index. */
interface CarrierNames {
  readonly rigidNames: readonly string[];
  readonly partNames: readonly string[];
}

/** A carrier as an option for parameters such as `vortices.0.rigid`. */
export interface CarrierChoice {
  readonly value: number;
  readonly label: string;
}

/** The world first, then the rigids, then the parts. */
export function carrierChoices({ rigidNames, partNames }: CarrierNames): readonly CarrierChoice[] {
  return [
    { value: -1, label: strings.items.world },
    ...rigidNames.map((label, rigid) => ({ value: rigid, label })),
    ...partNames.map((label, part) => ({ value: FIRST_PART + part, label })),
  ];
}

/** Whether both lists are equal. Scenes differ in their carriers. */
export function areSame(some: readonly CarrierChoice[], others: readonly CarrierChoice[]): boolean {
  return JSON.stringify(some) === JSON.stringify(others);
}
