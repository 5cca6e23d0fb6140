/** Factories for rows of the parameter table. */
import singles from '../singles.json' with { type: 'json' };
import type { ChoiceParameter, Keyed, NumberParameter, Parameter, Reader } from '../parameter.ts';

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

/** Key of a number that exists once in the simulator. */
export type SingleKey = keyof typeof singles;

type Shown = Named & Pick<NumberParameter, 'step'> & Partial<Pick<NumberParameter, 'slider' | 'unit' | 'isBaked'>>;

/**
 * A number that the simulator reads. Its range, default and unit are those of the simulator (see
 * sim-wasm/sim/tests/simulator/page_table.rs). A dimensionless number can show a unit.
 */
export function simulated<const Key extends SingleKey>(
  key: Key,
  group: string,
  rest: Shown,
): Keyed<NumberParameter, Key, 'simulator'> {
  const { unit, min, max, default: initial, whole } = singles[key];
  const range = { kind: whole ? 'integer' : 'number', unit: unitOf(unit), min, max, default: initial } as const;
  return quantity(key, group, 'simulator', { ...range, ...rest });
}

/** An optional simulator parameter that overrides the scene's value. */
export function ofScene(key: SingleKey, group: string, rest: Named & Partial<Shown>): NumberParameter {
  return { ...simulated(key, group, { step: 0.05, slider: 'fine', ...rest }), isOptional: true };
}

/** The simulator's unit as displayed: without `1`, and with raised powers. */
export function unitOf(unit: string): string {
  return unit === '1' ? '' : unit.replace(/(?<=[a-z])[23]/g, (power) => (power === '2' ? '\u00b2' : '\u00b3'));
}

/** A choice of the simulator. */
export function choiceOf(key: SingleKey, group: string, rest: Named, labels: readonly string[]): ChoiceParameter {
  const { names, default: initial } = singles[key];
  const options = names.map((name, index) => [name, labels[index]] as const);
  return choice(key, group, 'simulator', { ...rest, default: names[initial] }, options);
}

/** An optional choice of the simulator. */
export function choiceOfScene(key: SingleKey, group: string, rest: Named, labels: readonly string[]): ChoiceParameter {
  return { ...choiceOf(key, group, rest, labels), isOptional: true };
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
