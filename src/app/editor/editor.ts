import {
  defaultPreset,
  findParameter,
  findPreset,
  presetValues,
  type State,
  type Value,
  type Values,
} from '../../preset.ts';
import { History } from './history.ts';

/** Changed values; undefined for optional parameters that reverted to the scene's value. */
export type Changes = Readonly<Record<string, Value | undefined>>;

/** Called after each change with the new state and the changed values. */
export type EditListener = (state: State, changed: Changes) => void;

/**
 * Model of the page: a preset and its values, with undo. Panel, stage and address bar subscribe to it; it does not
 * depend on them.
 */
export class Editor {
  private current: State;
  private readonly history = new History<State>();
  private readonly listeners: EditListener[] = [];

  constructor(state: State) {
    this.current = state;
  }

  get state(): State {
    return this.current;
  }

  get canUndo(): boolean {
    return this.history.canUndo;
  }

  get canRedo(): boolean {
    return this.history.canRedo;
  }

  /** The preset's own values, which "reset" restores. */
  get base(): Values {
    return presetValues(findPreset(this.current.preset) ?? defaultPreset);
  }

  listen(listener: EditListener): void {
    this.listeners.push(listener);
  }

  /** Sets one value. Changes with the same gesture are undone together, until `settle`. */
  change(key: string, value: Value, gesture?: string): void {
    this.changeAll({ [key]: value }, gesture);
  }

  /** Sets several values, or removes optional ones, as one change. */
  changeAll(changes: Changes, gesture?: string): void {
    const entries = Object.entries({ ...this.current.values, ...changes });
    const values = Object.fromEntries(entries.filter((entry): entry is [string, Value] => entry[1] !== undefined));
    this.replace({ ...this.current, values }, gesture);
  }

  /** Ends a gesture. */
  settle(): void {
    this.history.settle(this.current, (a, b) => a.preset === b.preset && isEmpty(differences(a.values, b.values)));
    this.notify({});
  }

  reset(key: string): void {
    this.changeAll({ [key]: this.base[key] });
  }

  resetAll(): void {
    this.replace({ ...this.current, values: this.base });
  }

  /** Selects a preset. Within the same scene the camera stays. */
  choose(preset: string, gesture?: string): void {
    const values = presetValues(findPreset(preset) ?? defaultPreset);
    const eye = values.scene === this.current.values.scene ? eyeOf(this.current.values) : {};
    this.replace({ preset, values: { ...eye, ...values } }, gesture);
  }

  /** Replaces the whole state, for example from a link. Can be undone. */
  load(state: State): void {
    this.replace(state);
  }

  /**
   * Adopts values that were set on the stage directly, for example from the console. Consecutive calls are undone
   * together.
   */
  adopt(values: Values): void {
    this.replace({ ...this.current, values }, 'stage');
  }

  undo(): void {
    this.goTo(this.history.undo(this.current));
  }

  redo(): void {
    this.goTo(this.history.redo(this.current));
  }

  private replace(next: State, gesture?: string): void {
    const changed = differences(this.current.values, next.values);
    if (next.preset === this.current.preset && isEmpty(changed)) return;
    this.history.record(this.current, gesture);
    this.show(next, changed);
  }

  private goTo(next: State | undefined): void {
    if (next) this.show(next, differences(this.current.values, next.values));
  }

  private show(next: State, changed: Changes): void {
    this.current = next;
    this.notify(changed);
  }

  private notify(changed: Changes): void {
    for (const listener of this.listeners) listener(this.current, changed);
  }
}

/** Those of the values that belong to the camera. */
function eyeOf(values: Values): Values {
  return Object.fromEntries(Object.entries(values).filter(([key]) => findParameter(key)?.reader === 'camera'));
}

/** Values of `after` that differ from `before`; undefined for keys that `after` lacks. */
export function differences(before: Values, after: Values): Changes {
  // A state contains a few dozen of the table's thousands of keys.
  const keys = new Set([...Object.keys(before), ...Object.keys(after)]);
  return Object.fromEntries([...keys].filter((key) => before[key] !== after[key]).map((key) => [key, after[key]]));
}

function isEmpty(values: Changes): boolean {
  return Object.keys(values).length === 0;
}
