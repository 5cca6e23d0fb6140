/** Factories for rows of the parameter table. */
import type { ChoiceParameter, NumberParameter, Parameter, Reader } from '../parameter.ts';

type Named = Pick<Parameter, 'label' | 'text'>;
export type Quantity = Named & Partial<NumberParameter> & Pick<NumberParameter, 'min' | 'max' | 'step' | 'default'>;

/** A number parameter with its key, group of the panel, and reader. */
export function quantity(key: string, group: string, reader: Reader, rest: Quantity): NumberParameter {
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

type Options = readonly (readonly [value: string | number, label: string])[];

type Choice = Named & Pick<ChoiceParameter, 'default'>;

export function choice(key: string, group: string, reader: Reader, rest: Choice, options: Options): ChoiceParameter {
  const list = options.map(([value, label]) => ({ value, label }));
  return { kind: 'choice', key, group, reader, ...rest, options: list };
}
