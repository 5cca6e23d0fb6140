import type { PuffForm } from '../device/puffTextures.ts';
import type { Color, Tone } from '../device/ramps.ts';
import type { Gradient } from '../passes/bodies.ts';
import type { InkLine } from '../passes/ink.ts';
import type { Values } from '../preset/parameter.ts';
import { parseColor, parseStops, surfaceShadowOf, type SurfaceToning } from './palette.ts';

/** How puffs become pixels: the product's own way, and three others to compare it with. */
export type Renderer = 'nailboards' | ComparisonRenderer;
export type ComparisonRenderer = 'selle' | 'sprites' | 'shadowMap';

/** Which renderers ask for casters. */
export const THROWS_SHADOW: Readonly<Record<Renderer, boolean>> = {
  nailboards: true,
  selle: false,
  sprites: false,
  shadowMap: true,
};

/** How smoke is drawn: the paper's four effects, each on or off by itself, and their colours. */
export interface Style extends SurfaceToning {
  renderer: Renderer;
  form: PuffForm;
  outlines: boolean;
  /** Whether sharp edges of surfaces are inked too. */
  creases: boolean;
  shadows: boolean;
  /** Steps of shadow: where `shadowDepth` volumes and more hold a place, the second is `deepShadow` times the first. */
  shadowSteps: 1 | 2;
  shadowDepth: number;
  deepShadow: Color;
  gradient: Gradient;
  gradientColor: Color;
  /** World heights between which the gradient 'height' runs, metres. */
  gradientHeights: readonly [bottom: number, top: number];
  /** Width of the band along silhouettes that look away from the light, 0..1. */
  rim: number;
  rimColor: Color;
  /** Colours of smoke without a tint over its age and over its temperature, 0..1 each; its own colour where empty. */
  ageColors: readonly Tone[];
  heatColors: readonly Tone[];
  /** Whether those colours run into each other instead of changing at their stops. */
  softColors: boolean;
  /** Width of the ink in CSS pixels. */
  outlineWidth: number;
  /** How much wider lines are away from the light, 0..1. */
  inkSwell: number;
  /** How much lines tremble from drawing to drawing, 0..1. */
  boil: number;
  /** Depth gap, in puff radii, beyond which a puff is outlined against what lies behind it. */
  innerLine: number;
  /** How much more gap, as a multiple of that, a line between puffs takes to reach its full width. */
  innerTaper: number;
  smokeColor: Color;
  /** Colours of smoke that an emitter or a collider has tinted. */
  tints: readonly [Color, Color, Color];
  inkColor: Color;
  /** What lies behind, from below to above, in the place of the scene's; its own where absent or empty. */
  backdropColors?: readonly Tone[];
}

/** What colours that nobody has set are. @param values every other key of the table */
export function automaticColors(values: Values): Values {
  const [red, green, blue] = surfaceShadowOf({ ...styleOf(values), surfaceShadowColor: undefined });
  return { 'style.surfaceShadowColor': `#${((red << 16) | (green << 8) | blue).toString(16).padStart(6, '0')}` };
}

/** Fields that are named as their parameters are, by how their values are read. */
const PLAIN = [
  'renderer',
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

/** Reads the style out of flat values that hold every key of the table that is not optional. */
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
