/**
 * Parameter table rows of the simulator's lists (emitters, vortices, winds and so on), such as
 * `vortices.0.circulation`. The simulator defines the fields of a list and generates lists.json (see
 * sim-wasm/sim/tests/simulator/page_table.rs).
 *
 * These rows are optional: a parameter without a value has the scene's value.
 */
import source from './lists.json' with { type: 'json' };
import type { ChoiceParameter, NumberParameter } from './parameter.ts';
import { unitOf } from './rows/row.ts';

/** Maximum number of items per list, as in the simulator. */
export const LIST_LIMIT = 8;

interface Field {
  readonly key: string;
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  /** One number, or three for a vector field. */
  readonly default: readonly number[];
  /** Initial value of a newly added item, if it differs from the default. */
  readonly start?: number;
  readonly whole: boolean;
  /** Names of the values 0, 1, ...; empty for a quantity. */
  readonly names: readonly string[];
  readonly label: string;
  readonly text: string;
}

interface List {
  readonly label: string;
  readonly fields: readonly Field[];
}

/** Excludes density over life, a list in the simulator that users edit as a curve: `emission.density`. */
const { density: _curve, ...lists }: Readonly<Record<string, List>> = source;

/** Names of the lists in order. */
export const listNames: readonly string[] = Object.keys(lists);

/** Label of an item, such as 'Vortex 2' for the second vortex. */
export function itemLabel(list: string, index: number): string {
  return `${lists[list].label} ${index + 1}`;
}

/** Singular label of a list, such as 'Vortex'. */
export function listLabel(list: string): string {
  return lists[list].label;
}

/** Values by flat key that create item `index` of a list with a visible effect. */
export function startValues(list: string, index: number): Record<string, number> {
  const { fields } = lists[list];
  const starting = fields.filter(({ start }) => start !== undefined);
  const chosen = starting.length > 0 ? starting : fields.filter((field) => field.names.length === 0).slice(0, 1);
  return Object.fromEntries(
    chosen.map((field) => [`${list}.${index}.${field.key}${endsOf(field)[0]}`, field.start ?? field.default[0]]),
  );
}

/** All rows of all items of all lists. */
export function listParameters(): (NumberParameter | ChoiceParameter)[] {
  return listNames.flatMap((name) =>
    Array.from({ length: LIST_LIMIT }, (_, index) => itemParameters(name, index)).flat(),
  );
}

function itemParameters(list: string, index: number): (NumberParameter | ChoiceParameter)[] {
  const group = `${list}.${index}`;
  return lists[list].fields.flatMap((field) =>
    endsOf(field).map((end, part) => {
      const key = `${group}.${field.key}${end}`;
      return field.names.length > 0 ? choiceOf(field, key, group) : numberOf(field, part, key, group);
    }),
  );
}

function endsOf(field: Field): readonly string[] {
  return field.default.length === 1 ? [''] : ['.x', '.y', '.z'];
}

function choiceOf({ names, label, text, default: [initial] }: Field, key: string, group: string): ChoiceParameter {
  const options = names.map((name) => ({ value: name, label: sentence(name) }));
  return {
    kind: 'choice',
    key,
    group,
    reader: 'simulator',
    isOptional: true,
    label,
    text,
    options,
    default: names[initial],
  };
}

function numberOf(field: Field, part: number, key: string, group: string): NumberParameter {
  const { min, max, text } = field;
  const span = max - min;
  const axis = field.default.length === 1 ? '' : ` ${'xyz'[part]}`;
  return {
    kind: field.whole ? 'integer' : 'number',
    key,
    group,
    reader: 'simulator',
    isOptional: true,
    label: `${field.label}${axis}`,
    text,
    unit: unitOf(field.unit),
    min,
    max,
    step: field.whole ? 1 : stepOf(span),
    slider: span > 5 && !field.whole ? 'fine' : 'even',
    default: field.default[part],
  };
}

/** A few hundred steps for small ranges. Large ranges need fine steps near zero, where most values are. */
function stepOf(span: number): number {
  return span <= 5 ? 0.01 : 0.05;
}

/** Converts `coneNozzle` to 'Cone nozzle'. */
function sentence(name: string): string {
  const words = name.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
  return words[0].toUpperCase() + words.slice(1);
}
