/** Options of a call, and their ranges. */
import { ParameterError } from '../../base/errors.ts';
import type { ShareLink } from '../../parameters/parameter.ts';
import type { PresetName } from '../../parameters/valueTypes.ts';

/** The effects, by name. */
export const EFFECTS = ['poof', 'pop', 'dust', 'trail', 'burst', 'whoosh', 'boom', 'vanish', 'appear', 'form'] as const;

export type Effect = (typeof EFFECTS)[number];

export interface PuffOptions {
  /** Default: 'poof'. */
  effect?: Effect;
  /** The word that 'form' makes, 1 to 40 characters. Default: the text of the target. */
  text?: string;
  /** Number of puffs, 1 to 500. Default: by effect and by the size of the target. */
  count?: number;
  /** Size of the puffs, relative to the effect's own, 0.25 to 4. Default: 1. */
  size?: number;
  /** Angle of the cone in which puffs leave, degrees, 0 to 360. Default: by effect. 'pop' ignores it. */
  spread?: number;
  /** Direction in which puffs leave, degrees: 0 is right, 90 up. Default: by effect. 'pop' ignores it. */
  direction?: number;
  /** Speed of the puffs, relative to the effect's own, 0 to 4. Default: 1. */
  speed?: number;
  /** A CSS colour. Smoke of at most four colours is visible at once; a fifth changes the oldest. */
  color?: string;
  /**
   * Name of a preset, such as 'lamp-noir', or a share link or its hash, whose colours, ink and light the smoke gets. All
   * visible smoke has one look: that of the latest call with this option.
   */
  preset?: PresetName | ShareLink;
  /** Time in which new puffs appear, seconds, 0 to 60. Default: by effect. */
  duration?: number;
  /** Seed of the random numbers, a whole number from 0. It applies if no other smoke is visible. Default: random. */
  seed?: number;
  /** Whether the smoke is above or below the page. All visible smoke is on the layer of the latest call. */
  layer?: 'above' | 'below';
  /** `z-index` of the canvas. Default: 9999 above the page, -1 below it. */
  zIndex?: number;
  /** Whether to show smoke although the user prefers reduced motion. Default: 'skip'. */
  reducedMotion?: 'skip' | 'play';
}

/** Options of `puff.wipe()`. */
export interface WipeOptions extends Pick<PuffOptions, 'color' | 'seed' | 'zIndex' | 'reducedMotion'> {
  /** Changes the page. It is called exactly once, while smoke covers the target, or without smoke if there is none. */
  to: () => unknown;
  /** Direction in which the smoke comes, degrees, -360 to 360: 0 is to the right, 90 up. Default: 0. */
  direction?: number;
  /** Seconds until everything is covered, 0.4 to 10. Default: 0.9. */
  duration?: number;
  /** Name of a preset, or a share link or its hash, whose colours, ink and light the smoke gets. */
  preset?: PuffOptions['preset'];
}
/** Maximum length of a word. */
export const MAX_TEXT = 40;

/** Range of each number. */
export const RANGES: Readonly<Record<string, readonly [min: number, max: number, isWhole?: true]>> = {
  count: [1, 500, true],
  size: [0.25, 4],
  spread: [0, 360],
  direction: [-360, 360],
  speed: [0, 4],
  duration: [0, 60],
  seed: [0, 2 ** 32 - 1, true],
  zIndex: [-(2 ** 31), 2 ** 31 - 1, true],
};

const CHOICES: Readonly<Record<string, readonly string[]>> = {
  effect: EFFECTS,
  layer: ['above', 'below'],
  reducedMotion: ['skip', 'play'],
};

const isColor = (color: unknown) => typeof color === 'string' && CSS.supports('color', color);

const isText = (text: unknown) => typeof text === 'string' && text.trim() !== '' && text.length <= MAX_TEXT;

/** @throws ParameterError for an unknown option or a value that is out of range */
export function requirePuffOptions(options: PuffOptions): void {
  if (typeof options !== 'object' || (options as unknown) === null)
    throw new ParameterError('options', options, `an object with ${OPTIONS.join(', ')}`);
  for (const [name, value] of Object.entries(options)) {
    if (value === undefined) continue;
    const accepted = acceptedBy(name, value);
    if (accepted !== undefined) throw new ParameterError(name, value, accepted);
  }
}

const WIPE_OPTIONS = ['to', 'direction', 'duration', 'color', 'preset', 'seed', 'zIndex', 'reducedMotion'];

/** @throws ParameterError for an unknown option or a value that is out of range */
export function requireWipeOptions(options: WipeOptions): void {
  if (typeof (options as WipeOptions | undefined)?.to !== 'function')
    throw new ParameterError('to', (options as WipeOptions | undefined)?.to, 'a function that changes the page');
  const { to: _, duration, ...others } = options;
  const unknown = Object.keys(others).find((name) => !WIPE_OPTIONS.includes(name));
  if (unknown !== undefined)
    throw new ParameterError(
      unknown,
      Reflect.get(others, unknown),
      `no value, because there is no such option. The options are ${WIPE_OPTIONS.join(', ')}`,
    );
  if (duration !== undefined && !(duration >= 0.4 && duration <= 10))
    throw new ParameterError('duration', duration, 'a number from 0.4 to 10');
  requirePuffOptions(others);
}

/** @returns undefined if the value is accepted, otherwise what is */
function acceptedBy(name: string, value: unknown): string | undefined {
  if (Object.hasOwn(CHOICES, name)) {
    return CHOICES[name].includes(value as string) ? undefined : CHOICES[name].join(', ');
  }
  if (Object.hasOwn(RANGES, name)) {
    const [min, max, isWhole] = RANGES[name];
    const isRight = isWhole ? Number.isInteger(value) : Number.isFinite(value);
    if (isRight && (value as number) >= min && (value as number) <= max) return undefined;
    return `a ${isWhole ? 'whole ' : ''}number from ${min} to ${max}`;
  }
  if (name === 'color') return isColor(value) ? undefined : 'a CSS colour, such as #f08a5d';
  if (name === 'text') return isText(value) ? undefined : `1 to ${MAX_TEXT} characters`;
  if (name === 'preset') return typeof value === 'string' ? undefined : 'the name of a preset, or a share link';
  return `no value, because there is no such option. The options are ${OPTIONS.join(', ')}`;
}

const OPTIONS = [...Object.keys(CHOICES), ...Object.keys(RANGES), 'color', 'preset', 'text'];
