/**
 * What one row of the parameter table says. From the rows come the panel, the share link, the attributes of the
 * element, the table in docs/parameters.md and the values that reach the simulator.
 */

import { MIN_STOPS, MAX_STOPS } from './curve.ts';
import { MIN_COLORS, MAX_COLORS } from './ramp.ts';

/** A value as callers, links and the simulator see it: a number, the name of a choice, or `#rrggbb`. */
export type Value = number | string;

/** Flat values by dotted key, such as `{ 'emission.rate': 240 }`. */
export type Values = Readonly<Record<string, Value>>;

/** Who acts on a parameter: the simulator takes numbers by the same key, the others read them in TypeScript. */
export type Reader = 'simulator' | 'style' | 'light' | 'camera' | 'stage';

interface Described {
  /** Flat dotted key, the same in links, attributes (with dashes) and Rust. */
  readonly key: string;
  /** Key of the group of the panel, see `groups`. */
  readonly group: string;
  /** Short name for people, without the unit. */
  readonly label: string;
  /** One sentence: what turning it does. */
  readonly text: string;
  readonly reader: Reader;
  /** Without a value of its own it is as the scene has it, so that values need not have the key. */
  readonly isOptional?: true;
  /** Changing it bakes puffs anew. */
  readonly isBaked?: true;
}

/** A quantity in a closed range. */
export interface NumberParameter extends Described {
  readonly kind: 'number' | 'integer';
  /** Unit as printed behind the number; empty for a plain factor. */
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  /** The most that a link may ask for, where that is less than `max`. */
  readonly linkMax?: number;
  /** What one press of an arrow key adds. */
  readonly step: number;
  /** How a slider spreads the range: `fine` gives small values most of the way (position cubed). */
  readonly slider: 'even' | 'fine';
  readonly default: number;
}

/** Off or on, as 0 or 1. */
export interface ToggleParameter extends Described {
  readonly kind: 'toggle';
  readonly default: 0 | 1;
}

/** One of a few values, each with a name for people. */
export interface ChoiceParameter extends Described {
  readonly kind: 'choice';
  readonly options: readonly { readonly value: Value; readonly label: string }[];
  readonly default: Value;
}

/** An sRGB colour, `#rrggbb` in lower case. */
export interface ColorParameter extends Described {
  readonly kind: 'color';
  readonly default: string;
}

/** A curve over 0..1, as stops `0:1,.5:.8,1:0` in the order of their places; values from 0 to 1, straight lines between. */
export interface CurveParameter extends Described {
  readonly kind: 'curve';
  readonly default: string;
}

/** Colours over 0..1, as stops `0:333344,.5:aab0c0,1:ffffff` in the order of their places; empty for none. */
export interface RampParameter extends Described {
  readonly kind: 'ramp';
  readonly default: string;
}

export type Parameter =
  CurveParameter | RampParameter | NumberParameter | ToggleParameter | ChoiceParameter | ColorParameter;

/** What a parameter accepts, in words that end the sentence 'it takes ...'. */
export function accepted(parameter: Parameter): string {
  switch (parameter.kind) {
    case 'toggle':
      return '0 or 1';
    case 'color':
      return 'a colour such as #f4efe6';
    case 'curve':
      return `${MIN_STOPS} to ${MAX_STOPS} stops such as 0:1,.5:.8,1:0, places rising from 0 to 1, values from 0 to 1`;
    case 'ramp':
      return `nothing, or ${MIN_COLORS} to ${MAX_COLORS} stops such as 0:333344,.5:aab0c0,1:ffffff, places rising from 0 to 1`;
    case 'choice':
      return parameter.options.map((option) => String(option.value)).join(', ');
    default: {
      const unit = parameter.unit && ` ${parameter.unit}`;
      const noun = parameter.kind === 'integer' ? 'a whole number' : 'a number';
      return `${noun} from ${parameter.min} to ${parameter.max}${unit}`;
    }
  }
}
