import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { Editor, type Changes } from '../../../src/demo/editor/editor.ts';
import { lowestPlace, placeOf, PLACES, stepBy, valueAt } from '../../../src/demo/panel/control.ts';
import { defaultState } from '../../../src/parameters/codec.ts';
import type { ModelFile } from '../../../src/parameters/file.ts';
import type { Value, Values } from '../../../src/parameters/parameter.ts';
import { isAccepted } from '../../../src/parameters/values.ts';
import { findParameter, table } from '../../../src/parameters/words/table.ts';
import type { NumberParameter } from '../../../src/parameters/words/words.ts';

const numbers = table.filter((row): row is NumberParameter => row.kind === 'number' || row.kind === 'integer');
const RATE = 'emission.rate';
const DUCK: ModelFile = { name: 'duck.glb', bytes: new Uint8Array(4), options: {} };

/** The part of a stage that an editor uses. */
class FakeStage {
  values: Values = defaultState().values;
  /** Rejects all changes. */
  rejects = false;
  readonly given: Values[] = [];
  private listener = () => {};

  get = () => this.values;

  on = (_event: unknown, listener: unknown) => {
    this.listener = listener as () => void;
    return () => {};
  };

  replace(values: Values): void {
    if (this.rejects) throw new Error('too many');
    this.given.push(values);
    this.change(values);
  }

  /** As from the console. */
  change(values: Values): void {
    this.values = values;
    this.listener();
  }
}

function editing() {
  const stage = new FakeStage();
  const [notices, notified]: [string[], Changes[]] = [[], []];
  const entered: Values[] = [];
  let arrive = (_error?: Error) => {};
  const enter = (values: Values) => {
    entered.push(values);
    return new Promise<void>(
      (resolve, reject) => (arrive = (error) => (error === undefined ? resolve() : reject(error))),
    );
  };
  const nextFrame = () => Promise.resolve();
  const models: (ModelFile | undefined)[] = [];
  const setModel = async (model: ModelFile | undefined) => {
    if (stage.rejects) throw new Error('damaged');
    models.push(model);
  };
  const notify = (message: string) => notices.push(message);
  const editor = new Editor(stage, defaultState().preset, { nextFrame, enter, setModel, notify });
  editor.listen((_state, changed) => notified.push(changed));
  return {
    editor,
    stage,
    notices,
    notified,
    entered,
    models,
    rate: () => editor.state.values[RATE],
    arrive: async (error?: Error) => {
      arrive(error);
      await editor.delivered();
    },
  };
}

describe('Editor', () => {
  it('reports changes, and nothing without a change', () => {
    const { editor, notified } = editing();
    editor.change(RATE, 200);
    editor.change(RATE, 200);
    expect(notified).toEqual([{ [RATE]: 200 }]);
  });

  it('reports a removed optional value as undefined', () => {
    const { editor, notified } = editing();
    editor.change('camera.distance', 5);
    editor.changeAll({ 'camera.distance': undefined });
    expect(notified).toEqual([{ 'camera.distance': 5 }, { 'camera.distance': undefined }]);
  });

  it('compares only values that are set', () => {
    const { editor, stage, notified } = editing();
    let reads = 0;
    const values: Values = { ...editor.state.values, [RATE]: 200 };
    const counting = new Proxy(values, {
      get(target, key) {
        reads += 1;
        return Reflect.get(target, key) as Value;
      },
    });
    stage.change(counting);
    expect(notified).toEqual([{ [RATE]: 200 }]);
    expect(reads).toBeLessThan(4 * Object.keys(values).length);
  });

  it('undoes and redoes', () => {
    const { editor, rate } = editing();
    const before = rate();
    editor.change(RATE, 200);
    editor.change(RATE, 300);
    editor.undo();
    expect(rate()).toBe(200);
    editor.undo();
    expect(rate()).toBe(before);
    expect(editor.canUndo).toBe(false);
    editor.redo();
    editor.redo();
    expect(rate()).toBe(300);
    expect(editor.canRedo).toBe(false);
  });

  it('undoes a gesture as one change', () => {
    const { editor, rate } = editing();
    const before = rate();
    for (const value of [200, 250, 300]) editor.change(RATE, value, RATE);
    editor.settle();
    for (const value of [310, 320]) editor.change(RATE, value, RATE);
    editor.settle();
    editor.undo();
    expect(rate()).toBe(300);
    editor.undo();
    expect(rate()).toBe(before);
  });

  it('forgets a gesture that ends at its start', () => {
    const { editor, rate } = editing();
    const before = rate() as number;
    for (const value of [200, before]) editor.change(RATE, value, RATE);
    editor.settle();
    expect(editor.canUndo).toBe(false);
  });

  it('drops the redo stack on a new change', () => {
    const { editor } = editing();
    editor.change(RATE, 200);
    editor.undo();
    editor.change('puff.size', 2);
    expect(editor.canRedo).toBe(false);
  });

  it('resets one value or all to the preset, not to the defaults of the table', () => {
    const { editor, rate } = editing();
    editor.choose('lamp-storm');
    const storm = rate();
    expect(storm).not.toBe(findParameter(RATE)!.default);
    editor.change(RATE, 1);
    editor.change('puff.size', 2);
    editor.reset(RATE);
    expect([rate(), editor.state.values['puff.size']]).toEqual([storm, 2]);
    editor.resetAll();
    expect(editor.state.values).toEqual(editor.base);
    editor.undo();
    expect(editor.state.values['puff.size']).toBe(2);
  });
});

describe('Editor and stage', () => {
  it('the stage gets all changes of a frame together, and undo as well', async () => {
    const { editor, stage } = editing();
    const before = editor.state.values;
    editor.change(RATE, 200);
    editor.change('camera.distance', 5);
    expect(stage.given).toEqual([]);
    await editor.delivered();
    expect(stage.given).toEqual([{ ...before, [RATE]: 200, 'camera.distance': 5 }]);
    editor.undo();
    editor.undo();
    await editor.delivered();
    expect(stage.values).toEqual(before);
    expect(stage.given).toHaveLength(2);
  });

  it('an edit that waits for the next frame and a change of the stage meanwhile both last', async () => {
    const { editor, stage } = editing();
    editor.change(RATE, 200);
    stage.change({ ...stage.values, 'camera.azimuth': 30 });
    await editor.delivered();
    for (const values of [stage.values, editor.state.values]) {
      expect([values[RATE], values['camera.azimuth']]).toEqual([200, 30]);
    }
  });

  it('what is set on the stage is known to the editor, is undone together, and does not go back to the stage', async () => {
    const { editor, stage, notified, rate } = editing();
    const before = rate();
    for (const value of [200, 210]) stage.change({ ...stage.values, [RATE]: value });
    expect([rate(), notified.length, stage.given.length]).toEqual([210, 2, 0]);
    stage.change({ ...stage.values });
    expect(notified).toHaveLength(2);
    editor.undo();
    await editor.delivered();
    expect([rate(), stage.values[RATE], editor.canUndo]).toEqual([before, before, false]);
  });

  it('a change that the stage rejects is reported and taken back', async () => {
    const { editor, stage, notices, rate } = editing();
    stage.rejects = true;
    editor.change(RATE, 200);
    await editor.delivered();
    expect(notices).toEqual(['too many']);
    expect(rate()).toBe(stage.values[RATE]);
  });

  it('a model is added, removed and added again by undo and redo, and stays with other presets and links', async () => {
    const { editor, models, stage } = editing();
    await editor.setModel(DUCK);
    expect(models).toEqual([DUCK]);
    editor.choose('lamp-noir');
    editor.load(defaultState());
    await editor.delivered();
    expect([editor.state.model, models]).toEqual([DUCK, [DUCK]]);
    editor.change(RATE, 200);
    for (let undone = 0; undone < 3; undone++) editor.undo();
    await editor.delivered();
    expect([models.length, stage.values[RATE]]).toEqual([1, defaultState().values[RATE]]);
    editor.undo();
    await editor.delivered();
    expect([editor.state.model, editor.canUndo, models]).toEqual([undefined, false, [DUCK, undefined]]);
    editor.redo();
    await editor.delivered();
    expect(models).toEqual([DUCK, undefined, DUCK]);
  });

  it('a model and the values of its file are one change', async () => {
    const { editor, rate } = editing();
    const before = rate();
    const { preset, values } = defaultState();
    await editor.setModel(DUCK, { preset, values: { ...values, [RATE]: 77 } });
    expect([editor.state.model, rate()]).toEqual([DUCK, 77]);
    editor.undo();
    expect([editor.state.model, rate(), editor.canUndo]).toEqual([undefined, before, false]);
  });

  it('a model that the stage rejects changes nothing, also by redo', async () => {
    const { editor, stage, notices } = editing();
    stage.rejects = true;
    await expect(editor.setModel(DUCK)).rejects.toThrow('damaged');
    expect([editor.state.model, editor.canUndo]).toEqual([undefined, false]);
    stage.rejects = false;
    await editor.setModel(DUCK);
    editor.undo();
    await editor.delivered();
    stage.rejects = true;
    editor.redo();
    await editor.delivered();
    expect([editor.state.model, notices]).toEqual([undefined, ['damaged']]);
  });

  it('what is edited while a scene is entered reaches the stage when it has arrived', async () => {
    const { editor, stage, arrive, entered } = editing();
    const before = stage.values;
    editor.choose('train');
    const train = editor.state.values;
    await Promise.resolve();
    editor.change(RATE, 200);
    // The scene before goes on, which is no edit.
    stage.change({ ...before, [RATE]: 7 });
    expect([editor.state.values.scene, editor.state.values[RATE]]).toEqual(['train', 200]);
    expect(stage.given).toEqual([]);
    stage.change(train);
    await arrive();
    expect(entered).toEqual([train]);
    expect(stage.given).toEqual([{ ...train, [RATE]: 200 }]);
    expect(stage.values).toBe(stage.given[0]);
  });

  it('returns to the scene that the stage has if it cannot enter another one', async () => {
    const { editor, stage, arrive, notices } = editing();
    editor.choose('train');
    await Promise.resolve();
    await arrive(new Error('no network'));
    expect(notices).toEqual(['no network']);
    expect(editor.state.values).toBe(stage.values);
    expect(stage.given).toEqual([]);
  });

  it('follows the stage where it was sent while the editor waited for another scene', async () => {
    const { editor, stage, arrive } = editing();
    editor.choose('train');
    await Promise.resolve();
    stage.change({ ...stage.values, scene: 'rocket' });
    await arrive();
    expect(editor.state.values.scene).toBe('rocket');
    expect(stage.given).toEqual([]);
  });
});

describe('slider', () => {
  it('reaches both ends of every range and shows every default', () => {
    for (const row of numbers) {
      expect(valueAt(row, PLACES), row.key).toBe(row.max);
      expect(valueAt(row, lowestPlace(row)), row.key).toBe(row.min);
      expect(placeOf(row, row.max), row.key).toBe(PLACES);
      expect(placeOf(row, row.min), row.key).toBe(lowestPlace(row));
    }
  });

  it('gives only short values that the table accepts', () => {
    const place = fc.integer({ min: -PLACES, max: PLACES });
    fc.assert(
      fc.property(fc.constantFrom(...numbers), place, (row, at) => {
        const value = valueAt(row, Math.max(at, lowestPlace(row)));
        expect(isAccepted(row, value)).toBe(true);
        expect(String(value).length).toBeLessThanOrEqual(10);
      }),
    );
  });

  it('moves by a step for a key press, also where the cubed slider is flat', () => {
    for (const row of numbers) {
      const middle = row.min < 0 ? 0 : row.min;
      const up = stepBy(row, middle, 1);
      expect(up, row.key).toBeGreaterThan(middle);
      expect(stepBy(row, up, -1), row.key).toBe(middle);
      expect(stepBy(row, row.max, 1), row.key).toBe(row.max);
    }
  });
});
