/**
 * Looks of emitters: a picture in which all puffs have a look, compared with that of smoke with the same colours, ink and
 * bites. Runs inside a page.
 */
import { inputOf, Lab, PLAIN_STYLE, type LabPicture, type LabPuff, type LabScene } from '../lab.ts';
import { fetchExtras } from '../../../src/renderer/extraPasses.ts';
import { withLooks, type LookSource } from '../../../src/renderer/looks.ts';
import { parseStops, plainColorOf, rampOf } from '../../../src/renderer/palette.ts';
import type { Style } from '../../../src/renderer/style.ts';
import { NO_STYLE, numberOfStyle, type LookStyle } from '../../../src/simulator/lookStyles.ts';
import { random } from '../random.ts';
import { ground } from '../solids.ts';

await fetchExtras({ ...PLAIN_STYLE, hasLooks: true });

const [WIDTH, HEIGHT] = [240, 180];

export interface Look extends Partial<LookStyle> {
  readonly tint?: number;
  /** Number of the option of `emitters.#.look.dissolve`. */
  readonly dissolve?: number;
}

/** A simulator with looks by index, from 1. */
function sourceOf(looks: readonly Look[]): LookSource {
  const numbers = new Float64Array(45);
  looks.forEach(({ tint = 0, dissolve = 0, ...style }, index) =>
    numbers.set([numberOfStyle({ ...NO_STYLE, ...style }), tint, dissolve], 3 * index),
  );
  return { lookStyles: () => numbers };
}

function styleWith(style: Partial<Style>, looks: readonly Look[]): Style {
  const plain = { ...PLAIN_STYLE, ...style };
  return withLooks(plain, {}, sourceOf(looks), plain);
}

/** Puffs of several ages and temperatures before a ground. */
function cloud(change: Partial<LabPuff> = {}): LabPuff[] {
  const next = random(7);
  return Array.from({ length: 24 }, () => ({
    place: [2 * next() - 1, 1.2 * next() - 0.6, next() - 0.5] as const,
    radius: 0.2 + 0.2 * next(),
    roll: 6 * next(),
    variation: Math.floor(4 * next()),
    seed: Math.floor(256 * next()),
    age: next(),
    temperature: 1.2 * next(),
    ...change,
  }));
}

export interface Comparison {
  /** Pixels that differ, and distinct colours of the first picture. */
  differing: number;
  colors: number;
  /** Largest difference of a channel. */
  most: number;
}

function compared(one: LabPicture, other: LabPicture): Comparison {
  const [a, b] = [one, other].map(({ pixels }) => new Uint32Array(pixels.slice().buffer));
  return {
    differing: a.reduce((sum, pixel, at) => sum + Number(pixel !== b[at]), 0),
    colors: new Set(a).size,
    most: one.pixels.reduce((most, byte, at) => Math.max(most, Math.abs(byte - other.pixels[at])), 0),
  };
}

/** What a case draws with, besides its style. */
export type Setting = Pick<LabScene, 'lamp' | 'pixelRatio' | 'view'> & { failsSelfTest?: boolean; erosion?: number };

/** @param looks of the puffs in turn: puff n has look 1 + n modulo their number */
function drawn(style: Style, setting: Setting, looks: number, hasTints = false): LabPicture {
  const { failsSelfTest, erosion, ...scene } = setting;
  const puffs = cloud({ erosion }).map((puff, index) => ({
    ...puff,
    look: looks && 1 + (index % looks),
    tint: hasTints ? index % 4 : 0,
  }));
  const all: LabScene = {
    width: WIDTH,
    height: HEIGHT,
    puffs,
    surfaces: [ground(-0.9, 4)],
    backdrop: { top: [90, 120, 160], bottom: [200, 200, 190] },
    ...scene,
    style,
  };
  const lab = new Lab({ ...all, failsSelfTest });
  const picture = lab.drawFrame({ ...inputOf(all), style });
  lab.dispose();
  return picture;
}

/** Smoke in which every puff has a look, beside smoke of that style. @param plain what the look changes of the style */
export function looksAsStyle(
  base: Partial<Style>,
  look: Look,
  plain: Partial<Style>,
  setting: Setting = {},
): Comparison {
  // Otherwise the shadow on surfaces follows from the colours of the smoke.
  const same = { ...base, surfaceShadowColor: [150, 140, 196] as const };
  const whole = drawn({ ...PLAIN_STYLE, ...same, ...plain }, setting, 0);
  return compared(drawn(styleWith(same, [look]), setting, 1), whole);
}

/** Ramps as a style has them. */
export function tonesOf(ramp: string): Style['stops'] {
  return parseStops(ramp);
}

/** Smoke with tints and with looks whose colours are those of the smoke, beside smoke with tints. */
export function sameColors(base: Partial<Style>, setting: Setting = {}): Comparison {
  const style = { ...PLAIN_STYLE, ...base };
  const textOf = (tones: Style['stops'] = []) => tones.map(({ from, color }) => `${from}:${hexOf(color)}`).join(',');
  const { ageColors, heatColors } = style;
  const isPlain = ageColors.length + heatColors.length === 0;
  const { lit } = rampOf(isPlain ? plainColorOf(style) : [255, 255, 255], style);
  const colors = { colors: textOf(lit), ageColors: textOf(ageColors), heatColors: textOf(heatColors) };
  const looks = [colors, {}, { ...colors, tint: 2 }];
  return compared(drawn(styleWith(base, looks), setting, 3, true), drawn(style, setting, 0, true));
}

function hexOf(color: readonly number[]): string {
  return color.map((channel) => channel.toString(16).padStart(2, '0')).join('');
}

/** Fifteen looks with bands by age and by temperature, which need several columns, and one puff with the last of them. */
export function manyLooks(isSoft: boolean): Comparison & { width: number; height: number } {
  const ramp = (first: number) =>
    Array.from({ length: 16 }, (_, at) => `${(at / 16).toFixed(3)}:${hexOf([first, 8 * at, 255 - 15 * at])}`).join(',');
  const looks = Array.from({ length: 15 }, (_, index) => ({
    ageColors: ramp(10 * index),
    heatColors: ramp(200 - index),
  }));
  const base: Partial<Style> = { softColors: isSoft };
  const style = styleWith(base, looks);
  const puffs = cloud().map((puff) => ({ ...puff, look: 15, temperature: 0, age: 0 }));
  const scene: LabScene = { width: WIDTH, height: HEIGHT, puffs };
  const lab = new Lab(scene);
  const picture = lab.drawFrame({ ...inputOf(scene), style });
  const { width, height } = lab.ramps.image;
  const own = style.looks!.styles[15]!;
  const bare = { ...scene, puffs: puffs.map((puff) => ({ ...puff, look: 0 })) };
  const plain = lab.drawFrame({ ...inputOf(bare), style: { ...own } });
  lab.dispose();
  return { ...compared(picture, plain), width, height };
}
