/** Types of parameters with what the panel and the documents say of them, and of these words alone. */
import type * as bare from '../parameter.ts';
import type { SingleValues } from '../valueTypes.ts';

/** What all kinds of parameters have. */
export interface ParameterDescription extends bare.ParameterDescription {
  /** Key of the panel group, see `groups`. */
  readonly group: string;
  /** Short display name, without the unit. */
  readonly label: string;
  /** One sentence about the effect. */
  readonly text: string;
  /** A change requires rebaking the puffs. */
  readonly isBaked?: true;
}

/** A quantity in a closed range. */
export interface NumberParameter extends bare.NumberParameter, ParameterDescription {
  /** Increment of one arrow key press. */
  readonly step: number;
  /** Slider scale: `even` is linear, `fine` is cubic and gives small values most of the track. */
  readonly slider: 'even' | 'fine';
}

/** Off or on, as 0 or 1. */
export interface ToggleParameter extends bare.ToggleParameter, ParameterDescription {}

/** One of several values, each with a display name. */
export interface ChoiceParameter extends bare.ChoiceParameter, ParameterDescription {
  readonly options: readonly { readonly value: bare.Value; readonly label: string }[];
}

/** An sRGB colour, `#rrggbb` in lower case. */
export interface ColorParameter extends bare.ColorParameter, ParameterDescription {}

/** A piecewise linear curve over 0..1, as stops `0:1,.5:.8,1:0` sorted by position; values from 0 to 1. */
export interface CurveParameter extends bare.CurveParameter, ParameterDescription {}

/** Colours over 0..1, as stops `0:333344,.5:aab0c0,1:ffffff` sorted by position; empty for none. */
export interface RampParameter extends bare.RampParameter, ParameterDescription {}

/** Points of a stroke in metres, as text `-.8:0:.1,.2:.35:0`; empty for the simulator's own. */
export interface PathParameter extends bare.PathParameter, ParameterDescription {}

/** Drawn puffs, as text; empty for none. */
export interface DrawingParameter extends bare.DrawingParameter, ParameterDescription {}

/** The outline of a shape, as text; empty for none. */
export interface OutlineParameter extends bare.OutlineParameter, ParameterDescription {}

/** A timeline as text; empty for none. */
export interface TimelineParameter extends bare.TimelineParameter, ParameterDescription {}

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

/** Without a group, the first part of the key is the group. */
type Words = Omit<ParameterDescription, keyof bare.ParameterDescription | 'group'> &
  Partial<Pick<ParameterDescription, 'group'>>;

/** Without a slider, it is `even`. The unit is for a dimensionless number. */
type NumberWords = Words & Pick<NumberParameter, 'step'> & Partial<Pick<NumberParameter, 'slider' | 'unit'>>;

/** The display names by the values. */
type ChoiceWords<Option extends bare.Value> = Words & { readonly options: Readonly<Record<Option, string>> };

/** The words of a parameter of any kind. */
export type AnyWords = Words & Partial<NumberWords & ChoiceWords<string>>;

/** The words of rows by their keys. A missing or an extra key does not compile. */
export type WordsOf<Rows extends readonly bare.Parameter[]> = {
  readonly [Row in Rows[number] as Row['key']]: Row['kind'] extends 'number' | 'integer'
    ? NumberWords
    : Row['kind'] extends 'choice'
      ? ChoiceWords<SingleValues[Row['key'] & keyof SingleValues]>
      : Words;
};
