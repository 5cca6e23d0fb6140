import { Color as ThreeColor, type IUniform } from 'three';
import type { StyleUniforms } from './gpu/frameView.ts';
import { MAX_STRETCH } from '../base/constants.ts';
import type { PuffForm } from './gpu/puffTextures.ts';
import { linear, scaled, writeColor, type Color, type Factors, type Illumination, type Tone } from './gpu/ramps.ts';
import type { AnyValues, Parameter, Value, Values } from '../parameters/parameter.ts';
import { styleRows } from '../parameters/rows/style.ts';
import { readCurve, type Stop } from '../parameters/curve.ts';
import { defaults } from '../parameters/values.ts';
import { hasDecay, illuminationOf } from './light.ts';
import {
  formatColor,
  litThresholdOf,
  parseColor,
  parseStops,
  smokeColorOf,
  surfaceShadowOf,
  type SurfaceToning,
} from './palette.ts';

/** How puffs are drawn: with nailboards and shadow volumes, or for comparison as by Selle and others. */
export type Renderer = 'nailboards' | 'selle';

/** How the stencil counts shadow volumes: by testing each pixel's receiver, or entries and exits as in the paper. */
export type Volumes = 'receiver' | 'counted';

type StyleRow = Extract<(typeof styleRows)[number], { readonly reader: 'style' }>;

type NameOf<Row extends StyleRow> = Row['key'] extends `style.${infer Name}` ? Name : never;

/** The value of a parameter as the renderer uses it. */
type FieldOf<Row extends StyleRow> =
  | (Row extends { readonly isOptional: true } ? undefined : never)
  | (Row['kind'] extends 'toggle'
      ? boolean
      : Row['kind'] extends 'color'
        ? Color
        : Row['kind'] extends 'ramp'
          ? readonly Tone[]
          : Row extends { readonly kind: 'choice'; readonly default: infer Option }
            ? Option
            : number);

/** Every parameter of the table that the style reads, by its name. */
type Fields = { [Row in StyleRow as NameOf<Row>]: FieldOf<Row> };

/** Parameters that fields with other names hold. */
type Combined =
  | 'ramp'
  | 'rampBlend'
  | 'ageRamp'
  | 'heatRamp'
  | 'tint1'
  | 'tint2'
  | 'tint3'
  | 'backdrop'
  | 'wash'
  | 'washColor'
  | 'gradientBottom'
  | 'gradientTop'
  | 'form';

/**
 * The style of smoke: the paper's four effects, each on or off, and their colours. Parameters of the table
 * (src/parameters/rows/style.ts) are fields of the same name, and further fields combine some of them.
 */
export interface Style extends Omit<Fields, Combined>, Pick<SurfaceToning, 'stops' | 'isBlended' | 'wash'> {
  form: PuffForm;
  /** How far puffs stand upright, 0..1. */
  upright: number;
  /** How far light follows the form of the whole smoke, 0..1. */
  plumeForm: number;
  /** Greatest ratio of the axes of a puff, 1 for puffs that do not stretch. */
  stretch: number;
  /** Part by which the lobes of young puffs are folded, 0..1. */
  billow: number;
  /** Whether puffs turn or stretch with the air, or unfold. Billboards do not. */
  isDeformed: boolean;
  /** Whether puffs have bites as they dissolve. */
  isEroded: boolean;
  /** Whether the bites lie along the stretch of a puff instead of turning with it. */
  isTorn: boolean;
  /** World heights between which the gradient 'height' runs, metres. */
  gradientHeights: readonly [bottom: number, top: number];
  /** Colours of untinted smoke over its age and over its temperature, 0..1 each; `smokeColor` if empty. */
  ageColors: readonly Tone[];
  heatColors: readonly Tone[];
  /** Share of the colour that the light does not scale, over temperature, 0..1 each; empty if it is 0 everywhere. */
  glow: readonly Stop[];
  /** Factors on the light in which smoke and surfaces have the colours of the style. */
  illumination: Illumination;
  /** Factors on the direct light of a lamp that weakens with distance, at the unit of its falloff; absent for other light. */
  lampLight?: Factors;
  /** Whether lights besides the key light shade smoke and surfaces: those of what glows, and of a scene. */
  hasAdditionalLights: boolean;
  /** Colours of smoke that an emitter or a collider has tinted. */
  tints: readonly [Color, Color, Color];
  /** Whether emitters may have looks of their own. */
  hasLooks: boolean;
  /** The looks of emitters; absent if all smoke is alike. */
  looks?: Looks;
  /** Background colours by height from bottom to top, instead of those of the scene; the scene's if absent or empty. */
  backdropColors?: readonly Tone[];
}

/** The looks of the smoke of emitters by their index. The first one, index 0, is that of the smoke. */
export interface Looks {
  /** Factors on the width of lines. */
  readonly inkWeights: readonly number[];
  /** The greatest of these factors, at least 1. */
  readonly widest: number;
  /** A bit for each look whose bites lie along the stretch of puffs. */
  readonly torn: number;
  /** Tints of looks without colours of their own; 0 for none. */
  readonly tints: readonly number[];
  /** The style with the colours of a look; undefined if it has those of the smoke. */
  readonly styles: readonly (Style | undefined)[];
  /** What they follow from. */
  readonly plain: Style;
  readonly numbers: Float64Array;
}

/**
 * Colours that are computed if a preset does not set them.
 * @param values every other key of the table
 */
export function automaticColors(values: Values): Values {
  const color = surfaceShadowOf({ ...styleOf(values), surfaceShadowColor: undefined });
  return { 'style.surfaceShadowColor': formatColor(color) };
}

const rows = styleRows.filter(({ reader }) => reader === 'style');

/** Builds a style from flat values, which must have every key of the table that is not optional. */
export function styleOf(values: Values): Style {
  const fields = Object.fromEntries(
    rows.map((row) => [nameOf(row), fieldOf(row, (values as AnyValues)[row.key])]),
  ) as Fields;
  const illumination = illuminationOf(values);
  const glow = glowOf(values);
  const { ramp, rampBlend, ageRamp, heatRamp, tint1, tint2, tint3, backdrop, ...others } = fields;
  const { wash, washColor, gradientBottom, gradientTop, form: plumeForm, ...same } = others;
  return {
    ...same,
    form: formOf(values),
    upright: values['puff.upright']!,
    plumeForm,
    ...deformationOf(values),
    isEroded:
      formOf(values) === 'lobes' &&
      values['style.renderer'] === 'nailboards' &&
      (values['emission.dissolve'] === 'erode' || values['emission.dissolve'] === 'tear'),
    isTorn: values['emission.dissolve'] === 'tear',
    gradientHeights: [gradientBottom, gradientTop],
    illumination,
    lampLight: hasDecay(values) ? illumination.direct : undefined,
    hasAdditionalLights: glow.length > 0 && showsAdditionalLights(same),
    hasLooks: Object.keys(values).some((key) => key.includes('.look.')),
    stops: ramp,
    isBlended: rampBlend,
    ageColors: ageRamp,
    heatColors: heatRamp,
    glow,
    tints: [tint1, tint2, tint3],
    backdropColors: backdrop,
    wash: { share: wash, color: washColor },
  };
}

/** As the simulator decides it: `is_deformed` in sim-wasm/sim/src/arrange/rows.rs. */
export function deformationOf(values: Values): Pick<Style, 'stretch' | 'billow' | 'isDeformed'> {
  const [rotation, moving, billow] = (['turn', 'stretch', 'billow'] as const).map((name) => values[`puff.${name}`]!);
  const endsStretched = values['emission.dissolve'] === 'tear' || values['emission.dissolve'] === 'thin';
  const stretch = endsStretched ? MAX_STRETCH : moving;
  const isDeformed = formOf(values) === 'lobes' && (rotation > 0 || stretch > 1 || billow > 0);
  return { stretch, billow, isDeformed };
}

/** Whether a style shows lights besides the key light. Smoke without shading shows none. */
export function showsAdditionalLights({ renderer, shading }: Pick<Style, 'renderer' | 'shading'>): boolean {
  return renderer === 'nailboards' && shading;
}

/** Drawn puffs are billboards. */
export function formOf(values: Values): PuffForm {
  return values['puff.drawing'] ? 'billboards' : values['puff.form']!;
}

function glowOf(values: Values): Stop[] {
  const stops = readCurve(values['emission.glow']!) ?? [];
  return stops.some(({ value }) => value > 0) ? stops : [];
}

function nameOf({ key }: Parameter): string {
  return key.slice('style.'.length);
}

function fieldOf({ kind }: Parameter, value: Value | undefined): unknown {
  if (kind === 'toggle') return value === 1;
  if (kind === 'color') return value === undefined ? undefined : parseColor(value as string);
  return kind === 'ramp' ? parseStops(value as string) : value;
}

/**
 * Uniforms of a style, for the shaders of all passes: each number, toggle and colour that is a field of {@link Style},
 * by its name, `inkPixels` and `gradientFactor`.
 */
export function styleUniforms(): StyleUniforms {
  const uniforms = Object.entries(styleOf(defaults())).flatMap(([name, value]): [string, IUniform][] => {
    if (typeof value === 'number' || typeof value === 'boolean') return [[name, { value }]];
    return Array.isArray(value) && typeof value[2] === 'number' ? [[name, { value: new ThreeColor() }]] : [];
  });
  return {
    ...Object.fromEntries(uniforms),
    inkPixels: { value: 0 },
    gradientFactor: { value: new ThreeColor() },
    rimGlow: { value: new ThreeColor() },
  };
}

/** @param pixelRatio pixels of the target for each CSS pixel */
export function setStyle(
  { inkPixels, gradientFactor, rimGlow, ...uniforms }: StyleUniforms,
  style: Style,
  pixelRatio: number,
): void {
  const fields: Readonly<Record<string, unknown>> = {
    ...style,
    // The rim is light, which smoke without shading does not show.
    rim: style.shading ? style.rim : 0,
    rimColor: scaled(style.rimColor, style.illumination.direct),
    inkColor: inkOf(style),
  };
  for (const [name, uniform] of Object.entries(uniforms)) {
    if (uniform.value instanceof ThreeColor) writeColor(fields[name] as Color, uniform as IUniform<ThreeColor>);
    else uniform.value = fields[name];
  }
  inkPixels.value = inkPixelsOf(style, pixelRatio);
  gradientFactor.value.fromArray(gradientFactorOf(style));
  rimGlow.value.fromArray(linear(style.rimColor));
}

/** Fills from the gradient's colour at its low end to the smoke's own colour at its high end. */
function gradientFactorOf(style: Style): number[] {
  const smokeColor = smokeColorOf(style);
  return style.gradientColor.map((channel, index) =>
    style.gradient === 'none' ? 1 : channel / Math.max(1, smokeColor[index]),
  );
}

/** The colour of ink in the light. It is the same in light and in shadow, so it follows the mean of both parts. */
export function inkOf({ inkColor, inkLight, illumination }: Style): Color {
  const { direct, ambient } = illumination;
  const factors = direct.map((factor, at) => 1 + inkLight * ((factor + ambient[at]) / 2 - 1));
  return scaled(inkColor, factors as unknown as Factors);
}

/** Width of outlines in pixels of the target; 0 without outlines. */
export function inkPixelsOf({ outlines, outlineWidth }: Style, pixelRatio: number): number {
  return outlines ? outlineWidth * pixelRatio : 0;
}

/** Largest width of a line in pixels of the target. */
export function widestLineOf(style: Style, pixelRatio: number): number {
  return inkPixelsOf(style, pixelRatio) * 2 ** style.inkSwell * (style.looks?.widest ?? 1);
}

/** Least N.L from which any lit smoke differs from smoke in shadow; -1 if some differs for every N.L. */
export function leastThresholdOf(style: Style): number {
  return Math.min(...[style, ...(style.looks?.styles ?? [])].map((each) => litThresholdOf(each ?? style)));
}
