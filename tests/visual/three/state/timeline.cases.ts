/** Timelines of smoke in a scene. */
import { Object3D } from 'three';
import { ParameterError } from '../../../../src/base/errors.ts';
import type { Values } from '../../../../src/parameters/parameter.ts';
import { readTimeline } from '../../../../src/parameters/timeline.ts';
import { CartoonSmoke } from '../../../../src/three/cartoonSmoke.ts';
import { draw, emptyHost, HANGING, type Host } from '../scene.ts';

const TEXT =
  '90*loop;emission.rate/0*20/30*120*e/70*40;style.smokeColor/0*ffffff/60*000000;light.kind/0*lamp;burst/15*0*20';

function make({ renderer, keyLight }: Host, timeline?: string): Promise<CartoonSmoke> {
  const values: Values = timeline === undefined ? HANGING : { ...HANGING, timeline };
  return CartoonSmoke.create({ renderer, keyLight, values });
}

/** Hashes after 100 steps of smoke that gets the timeline in each way, the first before its code is loaded. */
export async function hashes(): Promise<{ first: string[]; hashes: string[] }> {
  const host = emptyHost();
  const late = await make(host);
  late.set({ timeline: readTimeline(TEXT).timeline });
  late.update(0);
  late.update(0.05);
  const first = [String(late.stats.steps), String(late.get().timeline)];
  late.step(100);
  first.push(String(late.stats.steps));
  await late.complete();
  first.push(String(late.stats.steps), String(late.get().timeline === TEXT));
  const created = await make(host, TEXT);
  for (let step = 0; step < 100; ++step) created.step();
  const restarted = await make(host, TEXT);
  restarted.step(37);
  restarted.set({ 'emission.rate': 3 });
  restarted.step(5);
  restarted.restart();
  restarted.step(100);
  const all = [late, created, restarted];
  const found = all.map((smoke) => smoke.hash());
  for (const smoke of all) smoke.dispose();
  host.renderer.dispose();
  return { first, hashes: found };
}

/** Whether a value that a caller holds lasts until the next keyframe, also in another smoke that restores the state. */
export async function held(): Promise<{ rates: number[]; same: boolean; base: unknown; loose: boolean }> {
  const host = emptyHost();
  const [smoke, other] = [await make(host, TEXT), await make(host, TEXT)];
  const rateOf = (of: CartoonSmoke) => of['simulator'].parameters().get('emission.rate')!;
  smoke.step(30);
  smoke.set({ 'emission.rate': 7 });
  const rates = [];
  smoke.step(1);
  rates.push(rateOf(smoke));
  const state = smoke.save();
  smoke.step(39);
  rates.push(rateOf(smoke));
  smoke.step(1);
  rates.push(rateOf(smoke));
  other.step(3);
  other.restore(state);
  other.step(40);
  const same = smoke.hash() === other.hash();
  const base = smoke.get()['emission.rate'];
  const before = smoke.hash();
  smoke.set(smoke.get());
  const loose = smoke.hash() === before;
  for (const each of [smoke, other]) each.dispose();
  host.renderer.dispose();
  return { rates, same, base, loose };
}

/** An object that follows emitter 0 emits as the timeline says, in one batch of steps as in many. */
export async function follower(): Promise<{ same: boolean; alive: number[] }> {
  const host = emptyHost();
  const text = '200;emission.rate/0*0*h/60*300*h/90*0';
  const [one, many] = [await make(host, text), await make(host, text)];
  for (const smoke of [one, many]) smoke.emitFrom(new Object3D());
  one.step(60);
  const alive = [one.stats.alive];
  one.step(60);
  alive.push(one.stats.alive);
  for (let step = 0; step < 120; ++step) many.step();
  const same = one.hash() === many.hash();
  for (const each of [one, many]) each.dispose();
  host.renderer.dispose();
  return { same, alive };
}

/** The colour of the style between steps, and what the host determines. */
export async function drawn(): Promise<{ colors: unknown[]; light: unknown; hasDrawn: boolean }> {
  const host = emptyHost();
  const smoke = await make(host, TEXT);
  host.scene.add(smoke);
  smoke.update(0);
  smoke.update(1.5 / 60);
  const colors = [smoke['shown'].values['style.smokeColor']];
  smoke.step(29);
  colors.push(smoke['shown'].values['style.smokeColor'], smoke.get()['style.smokeColor']);
  const light = smoke['shown'].values['light.kind'];
  const hasDrawn = draw(host).length > 0 && smoke.stats.bodiesDrawn > 0;
  smoke.dispose();
  host.renderer.dispose();
  return { colors, light, hasDrawn };
}

/** Errors of invalid timelines: of the creation, of the call, and of the event before the code is loaded. */
export async function invalid(): Promise<unknown[]> {
  const host = emptyHost();
  const bad = '60;emission.rate/0*-5';
  const keyOf = (error: unknown) => (error instanceof ParameterError ? error.key : String(error));
  const early = await make(host);
  const events: string[] = [];
  early.addEventListener('error', ({ error }) => events.push(keyOf(error)));
  early.set({ timeline: { length: -1 } as never });
  await early.complete();
  const created = await make(host, bad).then(String, keyOf);
  let called = '';
  try {
    early.set({ timeline: bad });
  } catch (error) {
    called = keyOf(error);
  }
  const left = early.get().timeline;
  early.dispose();
  host.renderer.dispose();
  return [events, created, called, left];
}
