/**
 * Types of parameter table rows. The rows define the share link, the attributes of the element and the values for the
 * simulator. What the panel and the documents say of them is in `words/`, which widgets do not load.
 */

import { MIN_STOPS, MAX_STOPS } from './curve.ts';
import { DRAWING_LIMIT, MAX_DRAWINGS } from '../base/drawingText.ts';
import { OUTLINE_LIMIT } from '../base/outlineText.ts';
import { MIN_POINTS, MAX_POINTS } from './path.ts';
import { MIN_COLORS, MAX_COLORS } from './ramp.ts';
import type { ItemValues, SingleValues, PresetName } from './valueTypes.ts';

/** A parameter value: a number, the name of a choice, a colour `#rrggbb`, or the text of a curve, ramp, path, drawing or outline. */
export type Value = number | string;

/** Values by flat dotted key, of any type: for code that goes through the table. */
export type AnyValues = Readonly<Record<string, Value>>;

/** Values by flat dotted key, such as `{ 'emission.rate': 240 }`. */
export type Values = { readonly [Key in keyof (SingleValues & ItemValues)]?: (SingleValues & ItemValues)[Key] };

/** A link with `#`, or its hash. */
export type ShareLink = `${string}#${string}`;

/** The consumer of a parameter. The simulator takes numbers with the same key; TypeScript code reads the others. */
export type Reader = 'simulator' | 'style' | 'light' | 'camera' | 'stage';

/** What all kinds of parameters have. */
export interface ParameterDescription {
  /** Flat dotted key, identical in links and Rust. Attributes use dashes. */
  readonly key: string;
  readonly reader: Reader;
  /** What a change replaces, so that a timeline cannot animate it: puff shapes, shaders, the simulation or looks. */
  readonly fixed?: 'puffs' | 'shaders' | 'simulation' | 'looks';
  /** The key can be absent from values. The parameter then has the scene's value. */
  readonly isOptional?: true;
}

/** A quantity in a closed range. */
export interface NumberParameter extends ParameterDescription {
  readonly kind: 'number' | 'integer';
  /** Unit as displayed after the number; empty for a dimensionless number. */
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  /** Maximum in a link, if lower than `max`. */
  readonly linkMax?: number;
  readonly default: number;
}

/** Off or on, as 0 or 1. */
export interface ToggleParameter extends ParameterDescription {
  readonly kind: 'toggle';
  readonly default: 0 | 1;
}

/** One of several values. */
export interface ChoiceParameter extends ParameterDescription {
  readonly kind: 'choice';
  readonly options: readonly { readonly value: Value }[];
  readonly default: Value;
}

/** An sRGB colour, `#rrggbb` in lower case. */
export interface ColorParameter extends ParameterDescription {
  readonly kind: 'color';
  readonly default: string;
}

/** A piecewise linear curve over 0..1, as stops `0:1,.5:.8,1:0` sorted by position; values from 0 to 1. Empty if its default is. */
export interface CurveParameter extends ParameterDescription {
  readonly kind: 'curve';
  readonly default: string;
}

/** Colours over 0..1, as stops `0:333344,.5:aab0c0,1:ffffff` sorted by position; empty for none. */
export interface RampParameter extends ParameterDescription {
  readonly kind: 'ramp';
  readonly default: string;
}

/** Points of a stroke in metres, as text `-.8:0:.1,.2:.35:0`; empty for the simulator's own. */
export interface PathParameter extends ParameterDescription {
  readonly kind: 'path';
  readonly default: string;
}

/** Drawn puffs, as text; empty for none. */
export interface DrawingParameter extends ParameterDescription {
  readonly kind: 'drawing';
  readonly default: string;
}

/** The outline of a shape, as text; empty for none. */
export interface OutlineParameter extends ParameterDescription {
  readonly kind: 'outline';
  readonly default: string;
}

/** A timeline as text, which `timeline.ts` describes and reads; empty for none. */
export interface TimelineParameter extends ParameterDescription {
  readonly kind: 'timeline';
  readonly default: string;
}

/** Maximum length of a timeline as text, in characters. */
export const TIMELINE_LIMIT = 16_000;

export type Parameter =
  | TimelineParameter
  | CurveParameter
  | RampParameter
  | PathParameter
  | DrawingParameter
  | OutlineParameter
  | NumberParameter
  | ToggleParameter
  | ChoiceParameter
  | ColorParameter;

/** Describes the valid values in a phrase that completes the sentence 'it takes ...'. */
export function accepted(parameter: Parameter): string {
  switch (parameter.kind) {
    case 'toggle':
      return '0 or 1';
    case 'color':
      return 'a colour such as #f4efe6';
    case 'curve':
      return `${parameter.default ? '' : 'nothing, or '}${MIN_STOPS} to ${MAX_STOPS} stops such as 0:1,.5:.8,1:0, places rising from 0 to 1, values from 0 to 1`;
    case 'ramp':
      return `nothing, or ${MIN_COLORS} to ${MAX_COLORS} stops such as 0:333344,.5:aab0c0,1:ffffff, places rising from 0 to 1`;
    case 'path':
      return `nothing, or ${MIN_POINTS} to ${MAX_POINTS} points such as -.8:0:.1,.2:.35:0, below 100`;
    case 'drawing':
      return `nothing, or 1 to ${MAX_DRAWINGS} drawings of at most ${DRAWING_LIMIT} characters, as the drawing sheet writes them`;
    case 'outline':
      return `nothing, or an outline of at most ${OUTLINE_LIMIT} characters, as traceShape writes it`;
    case 'timeline':
      return `nothing, or a timeline of at most ${TIMELINE_LIMIT} characters`;
    case 'choice':
      return parameter.options.map((option) => String(option.value)).join(', ');
    default: {
      const unit = parameter.unit && ` ${parameter.unit}`;
      const noun = parameter.kind === 'integer' ? 'a whole number' : 'a number';
      const more = parameter.key.endsWith('.tint') ? ', of three colours that repeat' : '';
      return `${noun} from ${parameter.min} to ${parameter.max}${unit}${more}`;
    }
  }
}

/** A row with the literal type of its key and its reader. */
export type Keyed<Row, Key extends string, By extends Reader> = Row & { readonly key: Key; readonly reader: By };

/** A named preset. Its label and text are in `words/presets.ts`. */
export interface Preset {
  /** Name in links: the scene's name, followed by a dash and the look if it is not the scene's first preset. */
  readonly name: PresetName;
  readonly values: Values;
}
