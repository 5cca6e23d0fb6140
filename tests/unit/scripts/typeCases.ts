/**
 * What the types accept and reject. The compiler checks this file with the sources, and package.test.ts with the
 * declarations of the package.
 */
import type { SmokeProps } from '../../../src/fiber.ts';
import {
  CartoonSmoke,
  createStage,
  presets,
  presetValues,
  type CartoonSmokeOptions,
  type PresetName,
  type RemoteStage,
  type ShareLink,
  type Values,
} from '../../../src/index.ts';
import { decode, defaults, encode, type Preset } from '../../../src/preset.ts';
import { puff } from '../../../src/puff.ts';

type Host = Pick<CartoonSmokeOptions, 'renderer' | 'keyLight'>;

export async function accepted(smoke: CartoonSmoke, remote: RemoteStage, host: Host, key: string, index: number) {
  smoke.set(smoke.get());
  await remote.set(await remote.get());
  smoke.set({ 'emission.rate': 3, 'style.smokeColor': '#ffffff', 'style.tones': 3, 'style.shadows': 0 });
  smoke.set({ 'style.gradient': 'height', 'style.ramp': '0:333344,1:ffffff', 'emission.density': '0:1,1:0' });
  smoke.set({ 'emitters.0.speed': 2, 'emitters.7.shape': 'disc', 'winds.3.region.size.x': 1, 'jets.0.spread': 1 });
  smoke.set({ [key]: 3 });
  smoke.set({ [`emitters.${index}.speed`]: 3 });
  const form: Record<string, number | string> = {};
  smoke.set(form);
  const look: Values = { 'style.outlines': 0, 'style.tones': 1 };
  const link: ShareLink = await encode({ preset: 'lamp', values: presetValues('lamp') });
  const name: PresetName = presets[0].name;
  for (const preset of [name, link, 'lamp', 'https://example.org/?t=2#v=1', '#v=1&preset=wisp'] as const) {
    await CartoonSmoke.create({ ...host, preset, values: { ...look, ...presetValues(presets[1]) } });
    await puff(null, { preset });
  }
  const { state } = await decode('#');
  await createStage(new OffscreenCanvas(1, 1), { values: { ...defaults(), ...state.values } });
  const props: SmokeProps = { preset: 'campfire', values: look };
  return [props, presetValues(state.preset)];
}

export async function rejected(smoke: CartoonSmoke, remote: RemoteStage, host: Host, preset: Preset) {
  // @ts-expect-error no such key
  smoke.set({ 'emission.rates': 3 });
  // @ts-expect-error no such key of an item
  smoke.set({ 'emitters.0.speeds': 3 });
  // @ts-expect-error no such item
  smoke.set({ 'emitters.8.speed': 3 });
  // @ts-expect-error no such list
  smoke.set({ 'emitter.0.speed': 3 });
  // @ts-expect-error a text for a number
  smoke.set({ 'emission.rate': '3' });
  // @ts-expect-error a number for a colour
  smoke.set({ 'style.smokeColor': 5 });
  // @ts-expect-error no such option
  smoke.set({ 'style.gradient': 'rainbow' });
  // @ts-expect-error no such option of an item
  smoke.set({ 'emitters.0.shape': 'star' });
  // @ts-expect-error no such number
  smoke.set({ 'style.tones': 4 });
  // @ts-expect-error a boolean for a toggle
  smoke.set({ 'style.shadows': true });
  // @ts-expect-error a number for a ramp
  smoke.set({ 'style.ramp': 1 });
  // @ts-expect-error a number for a curve
  smoke.set({ 'emission.density': 1 });
  // @ts-expect-error no such key
  await remote.set({ 'emission.rates': 3 });
  // @ts-expect-error no such key
  await createStage(new OffscreenCanvas(1, 1), { values: { 'emission.rates': 3 } });
  // @ts-expect-error no such key
  await CartoonSmoke.create({ ...host, values: { 'emission.rates': 3 } });
  // @ts-expect-error no such preset
  await CartoonSmoke.create({ ...host, preset: 'lampp' });
  // @ts-expect-error no such option
  await CartoonSmoke.create({ ...host, keylight: host.keyLight });
  // @ts-expect-error no such preset
  await puff(null, { preset: 'lampp' });
  // @ts-expect-error no such option
  await puff(null, { colour: 'red' });
  // @ts-expect-error no such preset
  presetValues('lampp');
  // @ts-expect-error no such preset
  const props: SmokeProps = { preset: 'lampp' };
  // @ts-expect-error no such key
  const values: SmokeProps['values'] = { 'emission.rates': 3 };
  // @ts-expect-error values cannot be changed in place
  preset.values['emission.rate'] = 3;
  return [props, values];
}
