import type { PuffForm } from '../device/puffTextures.ts';
import type { Color, Tone } from '../device/ramps.ts';
import type { Gradient } from '../passes/bodies.ts';
import type { InkLine } from '../passes/ink.ts';
import type { Values } from '../preset/parameter.ts';
import { parseColor, parseStops, type Toning, type Wash } from './palette.ts';

/** How puffs become pixels: the product's own way, and three others to compare it with. */
export type Renderer = 'nailboards' | Rival;
export type Rival = 'selle' | 'sprites' | 'shadowMap';

/** Which renderers ask for casters. */
export const THROWS_SHADOW: Readonly<Record<Renderer, boolean>> = {
  nailboards: true,
  selle: false,
  sprites: false,
  shadowMap: true,
};

/** How smoke is drawn: the paper's four effects, each on or off by itself, and their colours. */
export interface Style extends Toning {
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
  /** Shades of one colour that surfaces take; their own colours where absent. */
  wash?: Wash;
}

/** Reads the style out of flat values that hold every key of the table. */
export function styleOf(values: Values): Style {
  return {
    renderer: values['style.renderer'] as Renderer,
    form: values['puff.form'] as PuffForm,
    shading: values['style.shading'] === 1,
    outlines: values['style.outlines'] === 1,
    creases: values['style.creases'] === 1,
    shadows: values['style.shadows'] === 1,
    shadowSteps: values['style.shadowSteps'] as 1 | 2,
    shadowDepth: values['style.shadowDepth'] as number,
    deepShadow: parseColor(values['style.deepShadow'] as string),
    gradient: values['style.gradient'] as Gradient,
    gradientColor: parseColor(values['style.gradientColor'] as string),
    gradientHeights: [values['style.gradientBottom'] as number, values['style.gradientTop'] as number],
    stops: parseStops(values['style.ramp'] as string),
    isBlended: values['style.rampBlend'] === 1,
    fill: values['style.fill'] as number,
    rim: values['style.rim'] as number,
    rimColor: parseColor(values['style.rimColor'] as string),
    ageColors: parseStops(values['style.ageRamp'] as string),
    heatColors: parseStops(values['style.heatRamp'] as string),
    softColors: values['style.softColors'] === 1,
    outlineWidth: values['style.outlineWidth'] as number,
    inkSwell: values['style.inkSwell'] as number,
    boil: values['style.boil'] as number,
    innerLine: values['style.innerLine'] as number,
    innerTaper: values['style.innerTaper'] as number,
    tones: values['style.tones'] as 1 | 2 | 3,
    smokeColor: parseColor(values['style.smokeColor'] as string),
    tints: [tint(values, 1), tint(values, 2), tint(values, 3)],
    inkColor: parseColor(values['style.inkColor'] as string),
    backdropColors: parseStops(values['style.backdrop'] as string),
    wash: { share: values['style.wash'] as number, color: parseColor(values['style.washColor'] as string) },
  };
}

/** @param pixelRatio pixels of the target for each CSS pixel */
export function inkLineOf({ outlines, outlineWidth, inkSwell, inkColor }: Style, pixelRatio: number): InkLine {
  return { color: inkColor, pixels: outlines ? outlineWidth * pixelRatio : 0, swell: inkSwell };
}

function tint(values: Values, number: number): Color {
  return parseColor(values[`style.tint${number}`] as string);
}
