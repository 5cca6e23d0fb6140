import type { Stage } from '../../index.ts';
import {
  defaultPreset,
  findParameter,
  findPreset,
  presetValues,
  type ModelFile,
  type PresetName,
  type State,
  type AnyValues,
  type Value,
  type Values,
} from '../../preset.ts';

/** Wheels and keys have no end event. Their gesture ends after this time without input, in milliseconds. */
export const QUIET_MS = 300;

/** Changed values; undefined for optional parameters that reverted to the scene's value. */
export type Changes = Readonly<Record<string, Value | undefined>>;

/** What the page shows: the state of links, and the model in the scene, which links cannot contain. */
export interface PageState extends State {
  readonly model: ModelFile | undefined;
}

/** Called after each change with the new state and the changed values. */
export type EditListener = (state: State, changed: Changes) => void;

/** Turns changes into others, such as keyframes. */
export interface Recorder {
  /** Called before changes. @returns the changes to make instead */
  replace(changes: Changes): Changes;
  /** Called after the stage was changed by a gesture on it. */
  note(changes: Changes): void;
  /** Called at the end of a gesture. @returns changes that complete it */
  settle(): Changes;
}

/** The page around an editor. */
interface Surroundings {
  /** Resolves before the next frame of the page. */
  nextFrame(): Promise<unknown>;
  /** Makes the stage enter the scene of the values. */
  enter(values: Values): Promise<void>;
  /** Makes a model stand in the scene of the stage, or removes it. */
  setModel(model: ModelFile | undefined): Promise<void>;
  /** Reports what the stage rejected. */
  notify(message: string): void;
}

/**
 * Edits the values of a stage, with undo. The stage owns the values. The editor keeps the history of states, a preset
 * with its values each. What the present one has and the stage lacks are edits, which reach the stage once per frame.
 * Values that are set on the stage directly, for example from the console, enter the history, too.
 */
export class Editor {
  private readonly stage: Pick<Stage, 'get' | 'replace' | 'on'>;
  private readonly surroundings: Surroundings;
  private readonly history: History<PageState>;
  recorder: Recorder | undefined;
  private readonly listeners: EditListener[] = [];
  private readonly animationListeners: ((changed: Changes) => void)[] = [];
  private animated: AnyValues = {};
  /** The values that the stage had last, or was given. */
  private seen: Values;
  /** The model that the stage had last. */
  private seenModel: ModelFile | undefined;
  /** In progress while there are edits that the stage lacks. */
  private delivery: Promise<void> | undefined;

  /** @param preset name of the preset that the stage's values come from */
  constructor(stage: Pick<Stage, 'get' | 'replace' | 'on'>, preset: PresetName, surroundings: Surroundings) {
    this.stage = stage;
    this.surroundings = surroundings;
    this.seen = stage.get();
    this.history = new History<PageState>({ preset, values: this.seen, model: undefined });
    stage.on('statechange', () => this.updateAddress());
  }

  get state(): PageState {
    return this.history.present;
  }

  /** The values in effect: those of the state, but the present ones of animated parameters. */
  get shown(): AnyValues {
    return { ...this.state.values, ...this.animated };
  }

  /** Sets the present values of animated parameters, which are no change of the state. */
  animate(values: AnyValues): void {
    const changed = differences(this.animated, values);
    if (isEmpty(changed)) return;
    this.animated = values;
    for (const listener of this.animationListeners) listener(changed);
  }

  /** @param listener called when the present values of animated parameters have changed */
  listenToAnimation(listener: (changed: Changes) => void): void {
    this.animationListeners.push(listener);
  }

  /** Name of the gesture in progress. */
  get gesture(): string | undefined {
    return this.history.gesture;
  }

  get canUndo(): boolean {
    return this.history.canUndo;
  }

  get canRedo(): boolean {
    return this.history.canRedo;
  }

  /** The preset's own values, which "reset" restores. */
  get base(): Values {
    return presetValues(findPreset(this.state.preset) ?? defaultPreset);
  }

  listen(listener: EditListener): void {
    this.listeners.push(listener);
  }

  /** Resolves when the stage has all edits. Await it before changing the stage: later edits would overwrite the change. */
  async delivered(): Promise<void> {
    while (this.delivery) await this.delivery;
  }

  /** Sets one value. Changes with the same gesture are undone together, until `settle`. */
  change(key: string, value: Value, gesture?: string): void {
    this.changeAll({ [key]: value }, gesture);
  }

  /** Sets several values, or removes optional ones, as one change. */
  changeAll(changes: Changes, gesture?: string): void {
    const made = this.recorder?.replace(changes) ?? changes;
    // The stage has them only with the next frame.
    const animated = Object.entries(changes).filter(([key, value]) => value !== undefined && !(key in made));
    this.animated = { ...this.animated, ...(Object.fromEntries(animated) as AnyValues) };
    this.replace({ ...this.state, values: withChanges(this.state.values, made) }, gesture);
    if (gesture === undefined) this.recorder?.settle();
  }

  /** Ends a gesture. */
  settle(): void {
    const completing = this.recorder?.settle() ?? {};
    this.replace({ ...this.state, values: withChanges(this.state.values, completing) }, this.history.gesture);
    this.history.settle((a, b) => areSame(a, b));
    this.notify({});
  }

  reset(key: string): void {
    this.changeAll({ [key]: (this.base as AnyValues)[key] });
  }

  resetAll(): void {
    this.replace({ ...this.state, values: this.base });
  }

  /** Selects a preset. Within the same scene the camera stays. */
  choose(preset: string, gesture?: string): void {
    const found = findPreset(preset) ?? defaultPreset;
    const values = presetValues(found);
    const eye = values.scene === this.state.values.scene ? eyeOf(this.state.values) : {};
    this.replace({ ...this.state, preset: found.name, values: { ...eye, ...values } }, gesture);
  }

  /** Replaces the state, for example by that of a link. The model stays. Can be undone. */
  load(state: State): void {
    this.replace({ ...state, model: this.state.model });
  }

  /**
   * Adds a model to the scene, or removes it, and replaces the state. Can be undone as one change.
   * @throws what the stage rejects; nothing changes then
   */
  async setModel(model: ModelFile | undefined, state?: State): Promise<void> {
    await this.delivered();
    await this.surroundings.setModel(model);
    this.seenModel = model;
    this.replace({ ...(state ?? this.state), model });
  }

  undo(): void {
    this.go(() => this.history.undo());
  }

  redo(): void {
    this.go(() => this.history.redo());
  }

  private replace(next: PageState, gesture?: string): void {
    if (areSame(this.state, next)) return;
    this.go(() => this.history.record(next, gesture));
  }

  /** Changes the present state, and in the next frame the stage. */
  private go(move: () => void): void {
    this.show(move);
    this.delivery ??= this.deliver();
  }

  /**
   * Adopts what changed on the stage, and keeps the edits that it lacks. Until it has entered the scene of the present
   * state, its values are those of another one.
   */
  private updateAddress(): void {
    const values = this.stage.get();
    if (this.delivery && values.scene !== this.state.values.scene) return;
    const edits = differences(this.seen, this.state.values);
    this.seen = values;
    this.adopt({ values: withChanges(values, edits) });
  }

  /** Consecutive calls are undone together. */
  private adopt(present: Partial<PageState>): void {
    const next = { ...this.state, ...present };
    if (areSame(this.state, next)) return;
    this.recorder?.note(eyeOf(differences(this.state.values, next.values)));
    this.show(() => this.history.record(next, 'stage'));
  }

  private async deliver(): Promise<void> {
    await this.surroundings.nextFrame();
    const isTaken = await this.applyToStage(this.state);
    this.delivery = undefined;
    if (isTaken) this.updateAddress();
    else this.adopt({ values: (this.seen = this.stage.get()), model: this.seenModel });
    const { values, model } = this.state;
    if (model !== this.seenModel || !isEmpty(differences(this.seen, values))) this.delivery = this.deliver();
  }

  /** @returns whether the stage took the values. It does not if it rejects them, or was sent to another scene */
  private async applyToStage({ values, model }: PageState): Promise<boolean> {
    const isNew = !isEmpty(differences(this.seen, values));
    this.seen = values;
    try {
      if (model !== this.seenModel) {
        await this.surroundings.setModel(model);
        this.seenModel = model;
      }
      if (values.scene !== this.stage.get().scene) {
        await this.surroundings.enter(values);
        // The optional values of the scene itself are no change of the state.
        this.notify({});
      } else if (isNew) this.stage.replace(values);
    } catch (error) {
      this.surroundings.notify((error as Error).message);
      return false;
    }
    return values.scene === this.stage.get().scene;
  }

  private show(move: () => void): void {
    const { values } = this.state;
    move();
    const changed = differences(values, this.state.values);
    this.animated = Object.fromEntries(Object.entries(this.animated).filter(([key]) => !(key in changed)));
    this.notify(changed);
  }

  private notify(changed: Changes): void {
    for (const listener of this.listeners) listener(this.state, changed);
  }
}

function areSame(a: PageState, b: PageState): boolean {
  return a.preset === b.preset && a.model === b.model && isEmpty(differences(a.values, b.values));
}

/** Those of the values that belong to the camera. */
function eyeOf<Given extends Changes>(values: Given): Partial<Given> {
  const entries = Object.entries(values).filter(([key]) => findParameter(key)?.reader === 'camera');
  return Object.fromEntries(entries) as Partial<Given>;
}

function withChanges(values: Values, changes: Changes): Values {
  const entries = Object.entries({ ...values, ...changes });
  return Object.fromEntries(entries.filter((entry): entry is [string, Value] => entry[1] !== undefined));
}

/** Values of `after` that differ from `before`; undefined for keys that `after` lacks. */
export function differences(before: AnyValues, after: AnyValues): Changes {
  // A state contains a few dozen of the table's thousands of keys.
  const keys = new Set([...Object.keys(before), ...Object.keys(after)]);
  return Object.fromEntries([...keys].filter((key) => before[key] !== after[key]).map((key) => [key, after[key]]));
}

function isEmpty(values: Changes): boolean {
  return Object.keys(values).length === 0;
}

const MAX_ENTRIES = 200;

/**
 * Undo and redo over complete states. A gesture (dragging a slider, typing a number) counts as one change: it starts
 * with the first change with its name and ends with `settle` or with a change with another name.
 */
class History<Snapshot> {
  private past: Snapshot[] = [];
  private current: Snapshot;
  private future: Snapshot[] = [];
  private gestureName: string | undefined;

  constructor(present: Snapshot) {
    this.current = present;
  }

  /** Name of the gesture in progress. */
  get gesture(): string | undefined {
    return this.gestureName;
  }

  get present(): Snapshot {
    return this.current;
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  record(next: Snapshot, gesture?: string): void {
    const continues = gesture !== undefined && gesture === this.gestureName;
    if (!continues) {
      this.past.push(this.current);
      this.past.splice(0, this.past.length - MAX_ENTRIES);
      this.future = [];
    }
    this.gestureName = gesture;
    this.current = next;
  }

  /** Ends a gesture. A gesture that returned to its start leaves no undo step. */
  settle(isSame: (a: Snapshot, b: Snapshot) => boolean): void {
    if (this.gestureName !== undefined && isSame(this.past[this.past.length - 1], this.current)) this.past.pop();
    this.gestureName = undefined;
  }

  undo(): void {
    this.move(this.past, this.future);
  }

  redo(): void {
    this.move(this.future, this.past);
  }

  private move(from: Snapshot[], to: Snapshot[]): void {
    this.gestureName = undefined;
    const state = from.pop();
    if (state === undefined) return;
    to.push(this.current);
    this.current = state;
  }
}
