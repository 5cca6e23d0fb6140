/** Every row of the table at both ends of the range that links accept, applied to the stage of the page. */
import type { Page } from '@playwright/test';
import type { AnyValues, Parameter, Value, Values } from '../../../../src/parameters/parameter.ts';
import { table } from '../../../../src/parameters/words/table.ts';

/** One row, or all rows of a list item. */
export interface Trial {
  readonly name: string;
  readonly low: Values;
  readonly high: Values;
}

/** Additional values that a row needs to have a visible effect. */
const COMPANIONS: readonly (readonly [key: RegExp, values: Values])[] = [
  [/^style\.(shadowDepth|deepShadow)$/, { 'style.shadowSteps': 2, 'style.shadowDepth': 2 }],
  // Both ways to count agree, except in the gaps between lobes that a low light shows from the side.
  [/^style\.volumes$/, { 'light.elevation': 5, 'style.shadowSteps': 2, 'style.shadowDepth': 2 }],
  [/^style\.rampBlend$/, { 'style.ramp': '0:000000,1:ffffff' }],
  [/^style\.rimColor$/, { 'style.rim': 1 }],
  [/^style\.inkLight$/, { 'light.intensity': 0 }],
  [/^puff\.(precision|views)$/, { 'puff.form': 'billboards' }],
  // Strokes have at least 12 pixels.
  [/^style\.strokes$/, { 'camera.distance': 1.5, 'camera.target.x': 1.1, 'camera.target.y': 1.2 }],
  [/^style\.washColor$/, { 'style.wash': 1 }],
  [/^style\.softColors$/, { 'style.ageRamp': '0:000000,1:ffffff' }],
  [/^style\.gradient(Color|Bottom|Top)$/, { 'style.gradient': 'height' }],
  [/^style\.pattern./, { 'style.pattern': 'dots' }],
  [/^light\.(distance|decay)$/, { 'light.kind': 'lamp' }],
  [/^flows\.0\.(?!speed)/, { 'flows.0.speed': 1.5 }],
  [/^emission\.glow$/, { 'light.intensity': 0, 'light.ambient': 0.1 }],
];

const ENDS: Record<Exclude<Parameter['kind'], 'number' | 'integer' | 'choice'>, readonly [Value, Value]> = {
  toggle: [0, 1],
  color: ['#000000', '#ffffff'],
  curve: ['0:1,1:0', '0:0,.125:.5,.25:1,.375:.5,.5:1,.625:.25,.75:1,1:1'],
  ramp: ['', '0:ff0000,.1:00ff00,.2:0000ff,.3:ff00ff,.4:00ffff,.5:ffff00,1:ffffff'],
  path: ['', '-.3:0:0,0:.4:.1,.3:.8:-.1'],
  drawing: ['', 'ff8800*GRk-gg-Cg'],
  outline: ['', 'IBKiYqM3Owewd_uz8gxgxXxWxB-QuQuJ4WyeneZWOJIQSQSBCXPWPgPgPzE_Swjwi3yq0'],
  timeline: ['', '60;emission.rate/0*1'],
};

function endsOf(row: Parameter): readonly [Value, Value] {
  if (row.kind === 'choice') return [row.options[0].value, row.options.at(-1)!.value];
  if (row.kind === 'number' || row.kind === 'integer') return [row.min, row.linkMax ?? row.max];
  return ENDS[row.kind];
}

/** All rows at once at one end of their range. @param end 0 for the lower */
export function valuesAt(rows: readonly Parameter[], end: 0 | 1): Values {
  const companions = COMPANIONS.filter(([key]) => rows.some((row) => key.test(row.key))).map(([, values]) => values);
  return Object.assign({}, ...companions, Object.fromEntries(rows.map((row) => [row.key, endsOf(row)[end]]))) as Values;
}

const rowsOf = (readers: readonly Parameter['reader'][]) =>
  table.filter(({ reader, key }) => readers.includes(reader) && key !== 'scene');
const isLaterItem = ({ key }: Parameter) => /^\w+\.[1-7]\./.test(key);

/** Each row alone. List items are alike, so only the first item of each list. */
export function singleTrials(...readers: Parameter['reader'][]): Trial[] {
  return rowsOf(readers)
    .filter((row) => !isLaterItem(row))
    .map((row) => ({ name: row.key, low: valuesAt([row], 0), high: valuesAt([row], 1) }));
}

/** The other items of each list, with all rows of an item at once. */
export function itemTrials(): Trial[] {
  const items = new Map<string, Parameter[]>();
  for (const row of rowsOf(['simulator']).filter(isLaterItem)) {
    items.set(row.group, [...(items.get(row.group) ?? []), row]);
  }
  return [...items].map(([name, rows]) => ({ name, low: valuesAt(rows, 0), high: valuesAt(rows, 1) }));
}

/**
 * Names of the trials whose two ends lead to the same simulator state. Each saved state is restored, which throws if it
 * holds a non-finite number.
 */
export function withoutEffectOnState(page: Page, trials: readonly Trial[]): Promise<string[]> {
  return page.evaluate(async (list) => {
    const stage = window.cartoonSmoke!;
    // No pictures are needed.
    stage.resize(0, 0);
    // A timeline takes effect when its code is loaded.
    stage.set({ timeline: '60;emission.rate/0*1' });
    await stage.complete();
    stage.set({ timeline: '' });
    const capacity = Number(stage.get()['simulation.maxParticles']);
    const start = stage.save();
    const after = (values: Record<string, string | number>) => {
      stage.set({ 'simulation.maxParticles': capacity });
      stage.restore(start);
      stage.set(values);
      stage.step(1);
      const now: AnyValues = stage.get();
      const lost = Object.keys(values).filter((key) => now[key] !== values[key]);
      if (lost.length > 0) throw new Error(`The stage did not keep ${lost.join()}`);
      const state = stage.save();
      stage.restore(state);
      return { hash: stage.hash(), state };
    };
    const isSame = (a: ReturnType<typeof after>, b: ReturnType<typeof after>) =>
      a.hash === b.hash && a.state.length === b.state.length && a.state.every((byte, at) => byte === b.state[at]);
    return list.filter(({ low, high }) => isSame(after(low), after(high))).map(({ name }) => name);
  }, trials);
}

/** Names of the trials whose picture is the same at both ends and unchanged. */
export function withoutEffectOnPicture(page: Page, trials: readonly Trial[]): Promise<string[]> {
  return page.evaluate((list) => {
    const stage = window.cartoonSmoke!;
    const { canvas } = stage;
    const context = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true })!;
    const before = stage.get();
    const draw = (values: Record<string, string | number>) => {
      stage.set({ ...before, ...values });
      // A paused stage draws immediately when it becomes visible again, so its picture can be read in the same task.
      stage.visible = true;
      context.clearRect(0, 0, canvas.width, canvas.height);
      context.drawImage(canvas, 0, 0);
      const pixels = context.getImageData(0, 0, canvas.width, canvas.height).data.join();
      // Do not draw the intermediate states.
      stage.visible = false;
      const added = Object.keys(values).filter((key) => !(key in before));
      if (added.length > 0) stage.unset(added);
      return pixels;
    };
    stage.visible = false;
    const usual = draw({});
    return list.filter(({ low, high }) => draw(high) === usual && draw(low) === usual).map(({ name }) => name);
  }, trials);
}
