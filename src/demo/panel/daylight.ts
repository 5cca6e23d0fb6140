import { findPreset, presetValues, type PresetName, type Value, type Values } from '../../preset.ts';
import {
  formatColor,
  linear,
  mixed,
  parseColor,
  readCurve,
  readRamp,
  scaled,
  writeRamp,
  type Color,
} from '../../internal.ts';

/** The parameters that follow the hour. */
export const DAYLIGHT_KEYS = [
  'light.azimuth',
  'light.elevation',
  'light.color',
  'light.intensity',
  'light.ambientColor',
  'light.ambient',
  'style.inkLight',
  'style.backdrop',
] as const;

export type Daylight = Readonly<Record<(typeof DAYLIGHT_KEYS)[number], Value>>;

/** The hour at which all values are those of the preset. */
export const OWN_HOUR = 14;

/** Least elevation of a light, degrees; the moon shines while the sun is below it. */
const LOWEST = 5;

/** Azimuth and elevation of sun and moon by the hour, degrees: those of the preset times `own`, and added to them. */
const PATH: readonly (readonly [hour: number, own: 0 | 1, azimuth: number, elevation: number])[] = [
  [0, 0, -40, 48],
  [4.5, 0, -54, 36],
  [6, 0, -62, 32],
  [9.5, 1, -24, -6],
  [OWN_HOUR, 1, 0, 0],
  [16.5, 1, 16, -8],
  [18.5, 0, 64, 32],
  [20, 0, 50, 26],
  [22, 0, -25, 42],
  [24, 0, -40, 48],
];

/** Light of an hour: factors on the light of the preset, and the sky that its backdrop is mixed with. */
interface Light {
  readonly color: Color;
  readonly intensity: number;
  readonly ambientColor: Color;
  readonly ambient: number;
  /** How far ink follows the light, 0..1. */
  readonly ink: number;
  /** Share of the sky in the backdrop, 0..1. */
  readonly share: number;
  /** Colours of the sky from bottom to top. */
  readonly sky: readonly [Color, Color, Color];
}

const NIGHT = light('8ca8ff', 0.8, '6076cc', 0.5, 0.9, 0.45, '4a5c9c 28356e 121a44');
const OWN = light('ffffff', 1, 'ffffff', 1, 0, 0, 'ffffff ffffff ffffff');

const LIGHTS: readonly (readonly [hour: number, light: Light])[] = [
  [0, NIGHT],
  [4.5, NIGHT],
  [6, light('ffb890', 1, 'b4a4e0', 0.85, 0.3, 0.8, 'ffd0a8 eeaab8 8088c4')],
  [8, light('ffe6c4', 1, 'dcdaf4', 0.95, 0, 0.12, 'fff0d8 d8e0f0 9cbce8')],
  [OWN_HOUR, OWN],
  [16.5, light('fff0d0', 1, 'f0e6f4', 0.98, 0, 0.1, 'ffe0b0 f4d4cc a4b0dc')],
  [18.5, light('ffa868', 1.1, '9c88d8', 0.85, 0.4, 0.85, 'ffb268 ea7c88 5c4696')],
  [20, light('b48ad8', 0.7, '6e68c8', 0.62, 0.65, 0.8, 'b8709a 68508e 2c2c6c')],
  [22, NIGHT],
  [24, NIGHT],
];

function light(
  color: string,
  intensity: number,
  ambientColor: string,
  ambient: number,
  ink: number,
  share: number,
  sky: string,
): Light {
  const [bottom, middle, top] = sky.split(' ').map((each) => parseColor(`#${each}`));
  const [own, shade] = [parseColor(`#${color}`), parseColor(`#${ambientColor}`)];
  return { color: own, intensity, ambientColor: shade, ambient, ink, share, sky: [bottom, middle, top] };
}

/** The preset whose light the hours are relative to: of looks such as `train-night`, the one by day. */
export function dayOf(preset: PresetName): Values {
  const day = preset.replace(/-(dusk|night)$/, '');
  return presetValues(findPreset(day)?.name ?? preset);
}

/**
 * The values of light and backdrop at an hour. A lamp keeps its place and its strength. A look with colours by heat keeps all
 * of its light, because fire is its own, except where `emission.glow` keeps the fire bright at night.
 * @param hour 0 to 24
 * @param own values of the preset, which has them at {@link OWN_HOUR}; every key of the table that is not optional
 * @param sceneBackdrop ramp of the scene, which an empty `style.backdrop` shows
 */
export function daylight(hour: number, own: Values, sceneBackdrop: string): Daylight {
  if (hour === OWN_HOUR) return Object.fromEntries(DAYLIGHT_KEYS.map((key) => [key, own[key]])) as Daylight;
  const now = lightAt(hour);
  const isLamp = own['light.kind'] === 'lamp';
  const { color, intensity, ambientColor, ambient } = own['style.heatRamp'] === '' || glows(own) ? now : OWN;
  const [azimuth, elevation] = isLamp ? [own['light.azimuth']!, own['light.elevation']!] : placeAt(hour, own);
  return {
    'light.azimuth': azimuth,
    'light.elevation': elevation,
    'light.color': isLamp ? own['light.color']! : inColor(own['light.color']!, color),
    'light.intensity': isLamp ? own['light.intensity']! : strength(own['light.intensity']! * intensity),
    'light.ambientColor': inColor(own['light.ambientColor']!, ambientColor),
    'light.ambient': strength(own['light.ambient']! * ambient),
    'style.inkLight': rounded(own['style.inkLight']! + (1 - own['style.inkLight']!) * now.ink, 3),
    'style.backdrop': backdropAt(now, own['style.backdrop'] || sceneBackdrop),
  };
}

function glows(own: Values): boolean {
  return readCurve(own['emission.glow']!)?.some(({ value }) => value > 0) ?? false;
}

function lightAt(hour: number): Light {
  const [from, to, share] = around(LIGHTS, hour);
  const number = (key: 'intensity' | 'ambient' | 'ink' | 'share') => from[1][key] + share * (to[1][key] - from[1][key]);
  return {
    color: mixed(from[1].color, to[1].color, share),
    intensity: number('intensity'),
    ambientColor: mixed(from[1].ambientColor, to[1].ambientColor, share),
    ambient: number('ambient'),
    ink: number('ink'),
    share: number('share'),
    sky: from[1].sky.map((color, at) => mixed(color, to[1].sky[at], share)) as unknown as Light['sky'],
  };
}

/** Azimuth and elevation, degrees. The azimuth goes the short way round. */
function placeAt(hour: number, own: Values): readonly [azimuth: number, elevation: number] {
  const [from, to, share] = around(PATH, hour);
  const [start, end] = [from, to].map(([, isOwn, azimuth]) => isOwn * own['light.azimuth']! + azimuth);
  const [low, high] = [from, to].map(([, isOwn, , elevation]) => isOwn * own['light.elevation']! + elevation);
  const height = rounded(low + share * (high - low), 1);
  return [rounded(wrapped(start + share * wrapped(end - start)), 1), Math.min(Math.max(height, LOWEST), 90)];
}

/** Wraps degrees to the range from -180 (inclusive) to 180 (exclusive). */
function wrapped(degrees: number): number {
  return ((((degrees + 180) % 360) + 360) % 360) - 180;
}

/** The rows before and after an hour, and the eased share of the way between them. */
function around<Row extends readonly [hour: number, ...unknown[]]>(
  rows: readonly Row[],
  hour: number,
): readonly [from: Row, to: Row, share: number] {
  const next = Math.max(
    1,
    rows.findIndex(([at]) => at >= hour),
  );
  const [from, to] = [rows[next - 1], rows[next]];
  const share = (hour - from[0]) / (to[0] - from[0]);
  return [from, to, share * share * (3 - 2 * share)];
}

/** The backdrop in ambient light, mixed with the sky. Two colours get a third between them, so that a dusk is not grey. */
function backdropAt({ ambientColor, ambient, share, sky }: Light, text: string): string {
  const own = (readRamp(text) ?? []).map(({ at, color }) => ({ at, color: parseColor(color) }));
  if (own.length === 2) {
    const [low, high] = own;
    own.splice(1, 0, { at: (low.at + high.at) / 2, color: mixed(low.color, high.color, 0.5) });
  }
  const [red, green, blue] = linear(ambientColor).map((factor) => factor * ambient);
  return writeRamp(
    own.map(({ at, color }) => {
      const above = at < 0.5 ? mixed(sky[0], sky[1], 2 * at) : mixed(sky[1], sky[2], 2 * at - 1);
      return { at, color: formatColor(mixed(scaled(color, [red, green, blue]), above, share)) };
    }),
  );
}

function inColor(own: string, factor: Color): string {
  return formatColor(scaled(parseColor(own), linear(factor)));
}

function strength(value: number): number {
  return Math.min(rounded(value, 3), 4);
}

function rounded(value: number, decimals: number): number {
  // Adding 0 converts -0 to 0, as a link does.
  return Number(value.toFixed(decimals)) + 0;
}
