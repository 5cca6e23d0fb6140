/** Factories for rows of the parameter table. */
import singles from '../singles.json' with { type: 'json' };
import type { ChoiceParameter, Keyed, NumberParameter, ParameterDescription, Reader, Value } from '../parameter.ts';

type Quantity = Pick<NumberParameter, 'min' | 'max' | 'default'> &
  Partial<Pick<NumberParameter, 'kind' | 'unit' | 'linkMax'>>;

/** A number parameter with its key and reader. */
export function quantity<const Key extends string, const By extends Reader>(
  key: Key,
  reader: By,
  rest: Quantity,
): Keyed<NumberParameter, Key, By> {
  return { kind: 'number', unit: '', ...rest, key, reader };
}

/** Key of a number that exists once in the simulator. */
type SingleKey = keyof typeof singles;

/**
 * A number that the simulator reads. Its range, default and unit are those of the simulator (see
 * sim-wasm/sim/tests/simulator/page_table.rs).
 */
export function simulated<const Key extends SingleKey>(key: Key): Keyed<NumberParameter, Key, 'simulator'> {
  const { unit, min, max, default: initial, whole } = singles[key];
  return quantity(key, 'simulator', {
    kind: whole ? 'integer' : 'number',
    unit: unitOf(unit),
    min,
    max,
    default: initial,
  });
}

/** The simulator's unit as displayed: without `1`, and with raised powers. */
export function unitOf(unit: string): string {
  return unit === '1' ? '' : unit.replace(/(?<=[a-z])[23]/g, (power) => (power === '2' ? '\u00b2' : '\u00b3'));
}

/** A choice of the simulator. */
export function simulatedChoice<const Key extends SingleKey>(key: Key): Keyed<ChoiceParameter, Key, 'simulator'> {
  const { names, default: initial } = singles[key];
  return choice(key, 'simulator', names[initial], names);
}

/** An optional parameter, which overrides the scene's value. */
export function ofScene<Row>(row: Row): Row & { readonly isOptional: true } {
  return { ...row, isOptional: true };
}

/** A parameter that a timeline cannot animate. */
export function fixed<Row>(
  by: NonNullable<ParameterDescription['fixed']>,
  row: Row,
): Row & { readonly fixed: NonNullable<ParameterDescription['fixed']> } {
  return { ...row, fixed: by };
}

/** A choice with the literal types of its values. */
type ChoiceOf<Option extends Value> = ChoiceParameter & { readonly default: Option };

export function choice<const Key extends string, const By extends Reader, const Option extends Value>(
  key: Key,
  reader: By,
  initial: NoInfer<Option>,
  values: readonly Option[],
): Keyed<ChoiceOf<Option>, Key, By> {
  return { kind: 'choice', key, reader, default: initial, options: values.map((value) => ({ value })) };
}
