/** Proposes looks from the colours of a palette or of a picture. */
import { formatColor, mixed, parseColor, writeRamp } from '../../internal.ts';
import type { Value, Values } from '../../preset.ts';
import type { Changes } from '../editor/editor.ts';
import { chromaOf, distance, hexOf, huesApart, labOf, type Lab } from './color.ts';
import type { Found } from './picture.ts';

/** The proposals, in the order in which the page shows them. */
export const KINDS = ['whole', 'poster', 'night'] as const;

/** Colours that belong together, as `#rrggbb`. */
export interface Look {
  readonly kind: (typeof KINDS)[number];
  /** Tones of the smoke from shadow to full light. */
  readonly tones: readonly string[];
  readonly ink: string;
  readonly backdrop: readonly [bottom: string, top: string];
  /** Factors on the colours of surfaces in shadow, and on all colours in the second step of shadow. */
  readonly surfaceShadow: string;
  readonly deepShadow: string;
  readonly rim: string;
  /** Share and lightest shade of the wash on the objects of the scene. */
  readonly wash: number;
  readonly washColor: string;
  /** Light vivid colours for tinted smoke; fewer than three where the palette has no more. */
  readonly tints: readonly string[];
  /** Factors on the tones from cold to hot smoke. */
  readonly heat: readonly string[];
}

/**
 * What every look keeps, in OKLab: least differences of lightness between neighbouring tones, between ink and any tone, and
 * between the tone in full light and the backdrop, and the least distance of any tone from the backdrop.
 */
export const CONTRAST = { tones: 0.08, ink: 0.2, light: 0.15, backdrop: 0.07 } as const;

/** What rounding to bytes may take away. */
const SLACK = 0.008;
/** Range of the lightness of tones: darker ones would leave no room for ink. */
const [DARKEST_TONE, LIGHTEST_TONE] = [0.42, 0.985];
/** Greatest lightness of the tone in shadow, which would otherwise not look shaded. */
const LIGHTEST_SHADOW = 0.8;
const [DARKEST_INK, LIGHTEST_INK] = [0.05, 0.32];
/** Least chroma of a colour that is not a grey. */
const VIVID = 0.04;

interface Recipe {
  /** Least and greatest number of tones. */
  readonly tones: readonly [least: number, most: number];
  /** Least lightness of the tone in full light. */
  readonly light: number;
  /** Range of the lightness of the tone in shadow. */
  readonly shadow: readonly [least: number, most: number];
  /** Least difference of lightness between neighbouring tones. */
  readonly step: number;
  /** How much vividness counts beside lightness in the choice of tones. */
  readonly vividness: number;
  readonly wash: number;
  /** Lightness of the shadow factor on surfaces. */
  readonly surfaceShadow: number;
}

const RECIPES: Readonly<Record<Look['kind'], Recipe>> = {
  whole: { tones: [2, 5], light: 0.72, shadow: [0.5, 0.68], step: 0.09, vividness: 0, wash: 0.35, surfaceShadow: 0.68 },
  poster: { tones: [2, 2], light: 0.86, shadow: [0.56, 0.66], step: 0.2, vividness: 1.2, wash: 1, surfaceShadow: 0.6 },
  night: { tones: [3, 3], light: 0.84, shadow: [0.5, 0.62], step: 0.1, vividness: 0.2, wash: 0.6, surfaceShadow: 0.55 },
};

/** A colour of the palette and its share of the picture. */
interface Swatch {
  readonly lab: Lab;
  readonly share: number;
}

/**
 * Proposes one look of each kind. Colours are those of the palette, moved in lightness as far as {@link CONTRAST} demands.
 * @param found at least one colour
 */
export function looksOf(found: readonly Found[]): Look[] {
  const swatches = found.map(({ color, share }) => ({ lab: labOf(color), share }));
  const looks: Look[] = [];
  for (const kind of KINDS) looks.push(lookOf(kind, swatches, looks));
  return looks;
}

/** @param others looks from which its backdrop should differ */
function lookOf(kind: Look['kind'], swatches: readonly Swatch[], others: readonly Look[]): Look {
  const recipe = RECIPES[kind];
  const tones = tonesOf(recipe, swatches);
  const ink = inkOf(swatches, tones);
  const backdrop = backdropOf(kind, swatches, tones, others);
  const hue = shadowHue(swatches, tones[0]);
  const accents = accentsOf(swatches);
  const lightest = tones[tones.length - 1];
  const rim = accents[0] ?? lightest;
  return {
    kind,
    tones: tones.map(hexOf),
    ink: hexOf(ink),
    backdrop,
    surfaceShadow: hexOf(withLight(faded(hue, 0.07), recipe.surfaceShadow)),
    deepShadow: hexOf(withLight(faded(hue, 0.05), 0.76)),
    rim: hexOf(withLight(faded(rim, 0.08), Math.min(LIGHTEST_TONE, Math.max(rim.l, tones[0].l + 0.12, 0.88)))),
    wash: recipe.wash,
    washColor: hexOf(kind === 'night' ? tones[1] : withLight(lightest, Math.max(lightest.l, 0.85))),
    tints: accents.slice(0, 3).map((accent) => hexOf(withLight(accent, Math.max(accent.l, 0.68)))),
    heat: heatOf(swatches),
  };
}

/** What a look changes. The light becomes white, which shows the colours as they are. */
export function changesOf(look: Look, values: Values): Changes {
  const { tones, ink, backdrop, surfaceShadow, deepShadow, rim, wash, washColor, tints, heat } = look;
  const ramp = (colors: readonly string[], last: number): string =>
    writeRamp(colors.map((color, at) => ({ at: (last * at) / (colors.length - 1), color })));
  return {
    // As wide in the light as in shadow: the last tone starts where an equal part of the range is left.
    'style.ramp': ramp(tones, (tones.length - 1) / tones.length),
    'style.rampBlend': 0,
    'style.shading': 1,
    'style.smokeColor': tones[tones.length - 1],
    'style.inkColor': ink,
    'style.surfaceShadowColor': surfaceShadow,
    'style.deepShadow': deepShadow,
    'style.backdrop': ramp(backdrop, 1),
    'style.wash': wash,
    'style.washColor': washColor,
    'style.gradient': 'none',
    'style.rimColor': rim,
    ...(look.kind === 'night' && { 'style.rim': Math.max(values['style.rim'] ?? 0, 0.25) }),
    ...Object.fromEntries(tints.map((tint, at): [string, Value] => [`style.tint${at + 1}`, tint])),
    'style.ageRamp': '',
    // Fire stays visible as such.
    'style.heatRamp': values['style.heatRamp'] ? ramp(heat, 0.6) : '',
    'light.color': '#ffffff',
    'light.intensity': 1,
    'light.ambientColor': '#ffffff',
    'light.ambient': 1,
  };
}

/** Tones from dark to light. From the lightest on, each is a colour that has about its lightness and a similar hue. */
function tonesOf(recipe: Recipe, swatches: readonly Swatch[]): Lab[] {
  const { step, vividness } = recipe;
  const labs = swatches.map(({ lab }) => lab);
  const lights = labs.map(({ l }) => l).sort((a, b) => a - b);
  const count = Math.min(Math.max(levelsOf(lights, step), recipe.tones[0]), recipe.tones[1]);
  const light = Math.min(Math.max(lights[lights.length - 1], recipe.light), LIGHTEST_TONE);
  const darkest = lights.find((l) => l >= DARKEST_TONE) ?? light;
  const shadow = Math.min(Math.max(darkest, recipe.shadow[0]), recipe.shadow[1], light - (count - 1) * step);
  const chosen: Lab[] = [];
  for (let tone = 0; tone < count; tone++) {
    const target = light - ((light - shadow) * tone) / (count - 1);
    const cost = (lab: Lab): number => {
      const turn = tone === 0 ? 0 : 0.5 * huesApart(lab, chosen[tone - 1]);
      const isUsed = chosen.includes(lab) ? 0.06 : 0;
      return Math.abs(lab.l - target) + (tone === 0 ? 0 : turn - vividness * chromaOf(lab)) + isUsed;
    };
    chosen.push(least(labs, cost));
  }
  const chain = chosen.toReversed();
  const spread = spreadOut(
    chain.map(({ l }, tone) => {
      if (tone === count - 1) return light;
      return Math.min(Math.max(l, recipe.shadow[0]), tone === 0 ? LIGHTEST_SHADOW : light);
    }),
    step,
  );
  // What is compared with the tones are the colours that the page shows.
  return chain.map((lab, tone) => labOf(hexOf(withLight(lab, spread[tone]))));
}

/** How many tones the palette has, with a least difference of lightness. @param lights ascending */
function levelsOf(lights: readonly number[], step: number): number {
  let [levels, last] = [0, -Infinity];
  for (const l of lights) {
    if (l < DARKEST_TONE || l < last + step) continue;
    levels++;
    last = l;
  }
  return levels;
}

/** The nearest lightnesses that rise by a least step and stay within the range of tones. */
function spreadOut(lights: readonly number[], leastStep: number): number[] {
  const step = leastStep + SLACK;
  const rising = [...lights];
  for (let at = 0; at < rising.length; at++) {
    rising[at] = Math.max(rising[at], at === 0 ? DARKEST_TONE : rising[at - 1] + step);
  }
  for (let at = rising.length - 1; at >= 0; at--) {
    rising[at] = Math.min(rising[at], at === rising.length - 1 ? LIGHTEST_TONE : rising[at + 1] - step);
  }
  return rising;
}

/** The darkest colour, darkened where it is too close to the tone in shadow. */
function inkOf(swatches: readonly Swatch[], tones: readonly Lab[]): Lab {
  const { lab } = swatches.reduce((best, swatch) => (swatch.lab.l < best.lab.l ? swatch : best));
  const lightest = Math.min(LIGHTEST_INK, tones[0].l - CONTRAST.ink - SLACK);
  return withLight(lab, Math.min(Math.max(lab.l, DARKEST_INK), lightest));
}

/** A flat backdrop for a poster, otherwise a lighter colour below and a darker one above. */
function backdropOf(
  kind: Look['kind'],
  swatches: readonly Swatch[],
  tones: readonly Lab[],
  others: readonly Look[],
): [string, string] {
  const taken = [...tones, ...others.flatMap(({ backdrop }) => backdrop.map(labOf))];
  const hue = (lab: Lab): number => Math.min(0.15, ...tones.map((tone) => huesApart(tone, lab)));
  const isTaken = (lab: Lab): number => (taken.some((color) => distance(color, lab) < 0.12) ? 0.3 : 0);
  const worth: Readonly<Record<Look['kind'], (swatch: Swatch) => number>> = {
    // What covers much of a picture is likely its background. A quiet colour leaves the smoke in front.
    whole: ({ lab, share }) =>
      hue(lab) + 0.5 * share - Math.max(0, chromaOf(lab) - 0.12) - Math.abs(lab.l - 0.68) - isTaken(lab),
    poster: ({ lab }) => Math.min(0.18, chromaOf(lab)) + hue(lab) - Math.abs(lab.l - 0.6) - isTaken(lab),
    night: ({ lab }) => chromaOf(lab) - Math.abs(lab.l - 0.25),
  };
  const { lab } = least(swatches, (swatch) => -worth[kind](swatch));
  if (kind === 'poster') return flat(clearOf(tones, lab, Math.max(lab.l, 0.45)));
  const middle = Math.min(Math.max(lab.l, 0.5), 0.85);
  const [low, high] = kind === 'night' ? [0.34, 0.2] : [middle + 0.05, middle - 0.05];
  const [bottom, top] = [clearOf(tones, lab, low), clearOf(tones, lab, high)];
  return isClear(tones, bottom, top) ? [bottom, top] : flat(top);
}

function flat(color: string): [string, string] {
  return [color, color];
}

/** The colour in the lightness nearest to `wanted` in which the smoke is visible before it. */
function clearOf(tones: readonly Lab[], lab: Lab, wanted: number): string {
  const lights = Array.from({ length: 91 }, (_, at) => 0.08 + at / 100);
  lights.sort((a, b) => Math.abs(a - wanted) - Math.abs(b - wanted));
  const colorAt = (l: number): string => hexOf(withLight(lab, l));
  // There is always a dark one, because tones are light.
  return colorAt(lights.find((l) => isClear(tones, colorAt(l), colorAt(l)))!);
}

/** Whether the smoke is visible before all colours from one to another. */
function isClear(tones: readonly Lab[], bottom: string, top: string): boolean {
  const [low, high] = [parseColor(bottom), parseColor(top)];
  const shares = bottom === top ? [0] : [0, 0.25, 0.5, 0.75, 1];
  return shares.every((share) => {
    const behind = labOf(formatColor(mixed(low, high, share)));
    const differs = Math.abs(behind.l - tones[tones.length - 1].l) >= CONTRAST.light;
    return differs && tones.every((tone) => distance(tone, behind) >= CONTRAST.backdrop);
  });
}

/** The most vivid of the darker colours; that of a tone if all are grey. */
function shadowHue(swatches: readonly Swatch[], tone: Lab): Lab {
  const dark = swatches.map(({ lab }) => lab).filter(({ l }) => l < 0.6);
  return dark.length === 0 ? tone : least(dark, (lab) => -chromaOf(lab));
}

/** Vivid colours that differ in hue, the most vivid one first. */
function accentsOf(swatches: readonly Swatch[]): Lab[] {
  const rest = swatches.map(({ lab }) => lab).filter((lab) => chromaOf(lab) >= VIVID);
  const accents: Lab[] = [];
  while (accents.length < 3 && rest.length > 0) {
    const next = least(rest, (lab) => -chromaOf(lab) - Math.min(0.3, ...accents.map((one) => 2 * huesApart(one, lab))));
    if (accents.some((accent) => huesApart(accent, next) < VIVID)) break;
    accents.push(next);
  }
  return accents;
}

/** White for cold smoke, then the most vivid colours from dark to light. */
function heatOf(swatches: readonly Swatch[]): string[] {
  const labs = swatches.map(({ lab }) => lab).sort((a, b) => chromaOf(b) - chromaOf(a));
  const fire = labs.slice(0, 3).sort((a, b) => a.l - b.l);
  return ['#ffffff', ...fire.map((lab, at) => hexOf(withLight(lab, Math.max(lab.l, 0.55 + 0.12 * at))))];
}

function withLight({ a, b }: Lab, l: number): Lab {
  return { l, a, b };
}

/** With at most this chroma. */
function faded(lab: Lab, most: number): Lab {
  const scale = Math.min(1, most / (chromaOf(lab) || 1));
  return { l: lab.l, a: scale * lab.a, b: scale * lab.b };
}

/** The item with the least cost; the first of equal ones. */
function least<Item>(items: readonly Item[], cost: (item: Item) => number): Item {
  const costs = items.map(cost);
  return items[costs.reduce((best, each, at) => (each < costs[best] ? at : best), 0)];
}
