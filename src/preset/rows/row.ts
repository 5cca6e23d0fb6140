/** Factories for rows of the parameter table. */
import type { ChoiceParameter, NumberParameter, Parameter, Reader } from '../parameter.ts';

/** A row with the literal type of its key and its reader. */
export type Keyed<Row, Key extends string, By extends Reader> = Row & { readonly key: Key; readonly reader: By };

type Named = Pick<Parameter, 'label' | 'text'>;
export type Quantity = Named & Partial<NumberParameter> & Pick<NumberParameter, 'min' | 'max' | 'step' | 'default'>;

/** A number parameter with its key, group of the panel, and reader. */
export function quantity<const Key extends string, const By extends Reader>(
  key: Key,
  group: string,
  reader: By,
  rest: Quantity,
): Keyed<NumberParameter, Key, By> {
  return { kind: 'number', unit: '', slider: 'even', ...rest, key, group, reader };
}

/** An optional simulator parameter that overrides the scene's value. */
export function ofScene(
  key: string,
  group: string,
  rest: Named & Partial<NumberParameter> & { max: number; default: number },
): NumberParameter {
  const range = { min: 0, step: 0.05, slider: 'fine' } as const;
  return { ...quantity(key, group, 'simulator', { ...range, ...rest }), isOptional: true };
}

/** A choice with the literal types of its values. */
type ChoiceOf<Option> = ChoiceParameter & { readonly default: Option };

export function choice<const Key extends string, const By extends Reader, const Option extends string | number>(
  key: Key,
  group: string,
  reader: By,
  rest: Named & { readonly default: NoInfer<Option> },
  options: readonly (readonly [value: Option, label: string])[],
): Keyed<ChoiceOf<Option>, Key, By> {
  const list = options.map(([value, label]) => ({ value, label }));
  return { kind: 'choice', key, group, reader, ...rest, options: list };
}
