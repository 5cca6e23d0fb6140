/** Looks of emitters: colours, ink and bites of their smoke. Few smokes have them, so this module is loaded on demand. */
import code from '../../shaders/looks/looks.glsl';
import { LOOKS_LIMIT, MAX_STRETCH, TINTS } from '../base/constants.ts';
import type { AnyValues, ChoiceParameter } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import { FIRST_NUMBER, NO_STYLE, soundStyle, styleOfNumber, type LookStyle } from '../simulator/lookStyles.ts';
import type { Simulator } from '../simulator/simulator.ts';
import type { Bands, Ramp, Tone } from './gpu/ramps.ts';
import type { Shaders } from './gpu/programsAhead.ts';
import { bandsOf, parseStops, plainColorOf, rampOf, type Coloring } from './palette.ts';
import { ShaderVariant, withCode, type AddedCode } from './gpu/shaderVariant.ts';
import type { Looks, Style } from './style.ts';

/** Most materials of all looks together. */
export const MAX_MATERIALS = 2048;
/** Numbers of a look in `Simulator.lookStyles`: its style, the tint of its emitter, and how its puffs dissolve. */
const NUMBERS = 3;

/** The part of a simulator that knows the looks. */
export type LookSource = Pick<Simulator, 'lookStyles'>;

/**
 * A style with the looks that a simulator has now.
 * @param values that the style follows from
 * @param before the result of the last call, which is returned again if nothing has changed
 */
export function withLooks(plain: Style, values: AnyValues, simulator: LookSource, before: Style): Style {
  const numbers = simulator.lookStyles();
  const known = before.looks;
  if (known?.plain === plain && numbers.every((number, at) => number === known.numbers[at])) return before;
  const places = Array.from({ length: LOOKS_LIMIT }, (_, index) => NUMBERS * (index - 1));
  const found = places.map((at) => (numbers[at] > 0 ? foundStyle(numbers[at], values) : NO_STYLE));
  const dissolves = places.map((at) => dissolveOf(numbers[at + 2] ?? 0));
  const isTorn = dissolves.map((dissolve) => (dissolve === 'smoke' ? plain.isTorn : dissolve === 'tear'));
  const inkWeights = found.map(({ inkWeight }) => inkWeight);
  const styles = stylesOf(plain, found);
  const looks: Looks = {
    inkWeights,
    widest: Math.max(...inkWeights),
    torn: isTorn.reduce((bits, torn, index) => bits + (torn ? 1 << index : 0), 0),
    tints: places.map((at, index) => (styles[index] ? 0 : (numbers[at + 1] ?? 0))),
    styles,
    plain,
    numbers,
  };
  return { ...plain, ...dissolving(plain, dissolves), looks };
}

function foundStyle(number: number, values: AnyValues): LookStyle {
  if (number >= FIRST_NUMBER) return styleOfNumber(number) ?? NO_STYLE;
  return soundStyle((name) => values[`emitters.${number - 1}.look.${name}`]);
}

/** Equal colours give the same style. */
function stylesOf(plain: Style, looks: readonly LookStyle[]): (Style | undefined)[] {
  const made = new Map<string, Style>();
  return looks.map(({ colors, ageColors, heatColors }) => {
    if (colors + ageColors + heatColors === '') return undefined;
    const key = [colors, ageColors, heatColors].join(';');
    const style = made.get(key) ?? {
      ...plain,
      stops: colors ? parseStops(colors) : plain.stops,
      ageColors: ageColors ? parseStops(ageColors) : plain.ageColors,
      heatColors: heatColors ? parseStops(heatColors) : plain.heatColors,
    };
    made.set(key, style);
    return style;
  });
}

function dissolveOf(number: number): string {
  return String((findParameter('emitters.0.look.dissolve') as ChoiceParameter).options[number].value);
}

/** What the ways in which puffs dissolve change of a style; as the simulator decides it. */
function dissolving(plain: Style, dissolves: readonly string[]): Partial<Style> {
  const has = (...names: string[]) => names.some((name) => dissolves.includes(name));
  const isOfLobes = plain.form === 'lobes';
  const hasBites = has('erode', 'tear') && isOfLobes && plain.renderer === 'nailboards';
  return {
    ...(has('tear', 'thin') && { stretch: MAX_STRETCH, isDeformed: isOfLobes }),
    // Rows of the light have no looks: all shadows have bites of one kind.
    ...(hasBites && { isEroded: true, isTorn: plain.isEroded ? plain.isTorn : has('tear') }),
  };
}

/**
 * Adds the ramps of looks to those of a style.
 * @param bands those of the smoke
 * @returns the bands of each look
 */
export function addRamps(style: Style, ramps: Ramp[], bands: Bands): Bands[] {
  const { styles, tints, plain } = style.looks!;
  const different = [...new Set(styles)].filter((each) => each !== undefined);
  const needs = different.map((each) => materialsOf(each).length);
  const isTooMuch = needs.reduce((sum, need) => sum + need, 0) > MAX_MATERIALS;
  const most = isTooMuch ? Math.floor(MAX_MATERIALS / different.length) : MAX_MATERIALS;
  const ofSmoke = keyOf(plain);
  const made = new Map(
    different.map((each) => {
      const own = materialsOf(each, most);
      // Materials separate the smoke where light is simplified, so equal ones are the same.
      if (keyOf(each) === ofSmoke) return [each, bands];
      const found = ramps.length;
      ramps.push(...own);
      return [each, own.length === 1 ? bandsAt(found) : fewerBandsOf(each, found, most).bands];
    }),
  );
  return styles.map((each, look) => {
    if (each) return made.get(each)!;
    return tints[look] > 0 ? bandsAt(1 + ((tints[look] - 1) % TINTS)) : bands;
  });
}

/** The ramps of the bands of a look, or of its one colour. */
function materialsOf(style: Style, most = Infinity): Ramp[] {
  const { colors, glows } = fewerBandsOf(style, 0, most);
  if (colors.length === 0) return [rampOf(plainColorOf(style), style)];
  return colors.map((color, band) => ({ ...rampOf(color, style), glow: glows[band] }));
}

/** Equal for styles in which smoke has the same colours. */
function keyOf(style: Style): string {
  const ramps = materialsOf(style).map(({ isBlended = false, ...ramp }) => ({ ...ramp, isBlended }));
  return JSON.stringify([ramps, bandsOf(style, 0).bands]);
}

/** The bands of smoke that has one material. */
function bandsAt(material: number): Bands {
  const ages = Array.from({ length: 256 }, () => material);
  return { ages, temperatures: ages.map(() => 0) };
}

/** The bands of a look with at most this number of materials, at least 136. */
function fewerBandsOf(style: Coloring, first: number, most: number) {
  const whole = bandsOf(style, first);
  if (whole.colors.length <= most) return whole;
  const side = Math.floor(Math.sqrt(most));
  const fewer = (tones: readonly Tone[]) => tones.filter((_, at) => keeps(at, tones.length, side));
  const { ageColors, heatColors } = style;
  // Blended colours keep their stops, of which the steps are fewer.
  const coloring = style.softColors ? style : { ...style, ageColors: fewer(ageColors), heatColors: fewer(heatColors) };
  return bandsOf(coloring, first, side);
}

/** Whether an item is one of those, at most `most`, that are spread evenly over a list. */
function keeps(at: number, length: number, most: number): boolean {
  return length <= most || Math.floor((at * most) / length) !== Math.floor(((at - 1) * most) / length);
}

const LOOKS: AddedCode = { define: 'LOOKS', declared: 'LOOKS', code };

/** Shaders as {@link LookVariant} draws them. */
export function withLookCode(shaders: Shaders): Shaders {
  return withCode(shaders, LOOKS);
}

/** Puffs with looks: shaders/looks/looks.glsl and what it reads. */
export class LookVariant extends ShaderVariant {
  private readonly uniforms;

  constructor() {
    const uniforms = {
      inkWeights: { value: Array.from({ length: LOOKS_LIMIT }, () => 1) },
      tornLooks: { value: 0 },
    };
    super(LOOKS, uniforms);
    this.uniforms = uniforms;
  }

  apply({ inkWeights, torn }: Looks): void {
    this.uniforms.inkWeights.value = [...inkWeights];
    this.uniforms.tornLooks.value = torn;
  }
}
