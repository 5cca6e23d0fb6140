import type { PuffForm } from '../device/puffTextures.ts';
import type { Color, Tone } from '../device/ramps.ts';
import type { Gradient } from '../passes/bodies.ts';
import type { InkLine } from '../passes/ink.ts';
import type { Values } from '../preset/parameter.ts';
import { parseColor, parseStops, surfaceShadowOf, type SurfaceToning } from './palette.ts';

/** How puffs are drawn: with nailboards and shadow volumes, or with one of three renderers for comparison. */
export type Renderer = 'nailboards' | ComparisonRenderer;
export type ComparisonRenderer = 'selle' | 'sprites' | 'shadowMap';

/** How the stencil counts shadow volumes: by testing each pixel's receiver, or entries and exits as in the paper. */
export type Volumes = 'receiver' | 'counted';

/** The renderers that draw shadows and need casters. */
export const THROWS_SHADOW: Readonly<Record<Renderer, boolean>> = {
  nailboards: true,
  selle: false,
  sprites: false,
  shadowMap: true,
};

/** The style of smoke: the paper's four effects, each on or off, and their colours. */
export interface Style extends SurfaceToning {
  renderer: Renderer;
  form: PuffForm;
  outlines: boolean;
  /** Whether sharp edges of surfaces are inked too. */
  creases: boolean;
  shadows: boolean;
  volumes: Volumes;
  /** Steps of shadow. Where at least `shadowDepth` volumes overlap, the second step is `deepShadow` times the first. */
  shadowSteps: 1 | 2;
  shadowDepth: number;
  deepShadow: Color;
  gradient: Gradient;
  gradientColor: Color;
  /** World heights between which the gradient 'height' runs, metres. */
  gradientHeights: readonly [bottom: number, top: number];
  /** Width of the band along silhouettes that face away from the light, 0..1. */
  rim: number;
  rimColor: Color;
  /** Colours of untinted smoke over its age and over its temperature, 0..1 each; `smokeColor` if empty. */
  ageColors: readonly Tone[];
  heatColors: readonly Tone[];
  /** Whether those colours are interpolated instead of changing at their stops. */
  softColors: boolean;
  /** Width of outlines in CSS pixels. */
  outlineWidth: number;
  /** How much wider lines are on the side away from the light, 0..1. */
  inkSwell: number;
  /** How much lines vary from drawing to drawing, 0..1. */
  boil: number;
  /** Depth gap, in puff radii, beyond which a puff is outlined against what is behind it. */
  innerLine: number;
  /** Additional gap, as a multiple of `innerLine`, over which a line between puffs reaches its full width. */
  innerTaper: number;
  smokeColor: Color;
  /** Colours of smoke that an emitter or a collider has tinted. */
  tints: readonly [Color, Color, Color];
  inkColor: Color;
  /** Background colours from bottom to top, instead of those of the scene; the scene's if absent or empty. */
  backdropColors?: readonly Tone[];
}

/**
 * Colours that are computed if a preset does not set them.
 * @param values every other key of the table
 */
export function automaticColors(values: Values): Values {
  const [red, green, blue] = surfaceShadowOf({ ...styleOf(values), surfaceShadowColor: undefined });
  return { 'style.surfaceShadowColor': `#${((red << 16) | (green << 8) | blue).toString(16).padStart(6, '0')}` };
}

/** Fields with the same name as their parameter, grouped by the conversion of their values. */
const PLAIN = [
  'renderer',
  'volumes',
  'shadowSteps',
  'shadowDepth',
  'gradient',
  'fill',
  'rim',
  'outlineWidth',
  'inkSwell',
  'boil',
  'innerLine',
  'innerTaper',
  'tones',
] as const;
const TOGGLES = ['shading', 'outlines', 'creases', 'shadows', 'softColors'] as const;
const COLORS = ['deepShadow', 'gradientColor', 'rimColor', 'smokeColor', 'inkColor', 'surfaceShadowColor'] as const;

/** Builds a style from flat values, which must have every key of the table that is not optional. */
export function styleOf(values: Values): Style {
  const colorOf = (name: string) => parseColor(values[`style.${name}`] as string);
  const stopsOf = (name: string) => parseStops(values[`style.${name}`] as string);
  return {
    ...read(values, PLAIN, (value) => value),
    ...read(values, TOGGLES, (value) => value === 1),
    ...read(values, COLORS, (color?: string) => color && parseColor(color)),
    form: values['puff.form'] as PuffForm,
    gradientHeights: [values['style.gradientBottom'] as number, values['style.gradientTop'] as number],
    stops: stopsOf('ramp'),
    isBlended: values['style.rampBlend'] === 1,
    ageColors: stopsOf('ageRamp'),
    heatColors: stopsOf('heatRamp'),
    tints: [colorOf('tint1'), colorOf('tint2'), colorOf('tint3')],
    backdropColors: stopsOf('backdrop'),
    wash: { share: values['style.wash'] as number, color: colorOf('washColor') },
  };
}

function read<Key extends keyof Style>(values: Values, keys: readonly Key[], parse: (value: never) => unknown) {
  return Object.fromEntries(keys.map((key) => [key, parse(values[`style.${key}`] as never)])) as Pick<Style, Key>;
}

/** @param pixelRatio pixels of the target for each CSS pixel */
export function inkLineOf({ outlines, outlineWidth, inkSwell, inkColor }: Style, pixelRatio: number): InkLine {
  return { color: inkColor, pixels: outlines ? outlineWidth * pixelRatio : 0, swell: inkSwell };
}
