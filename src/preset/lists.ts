/**
 * The rows of the table for the simulator's lists - emitters, vortices, winds and so on -, `vortices.0.circulation` for
 * one. What a list holds is said by the simulator, which writes lists.json (see sim-wasm/sim/tests/simulator/page_table.rs).
 *
 * These rows are optional: without a value of its own, a parameter is as the scene has it.
 */
import source from './lists.json' with { type: 'json' };
import type { ChoiceParameter, NumberParameter } from './parameter.ts';

/** Most items of each list, as in the simulator. */
export const LIST_LIMIT = 8;

interface Field {
  readonly key: string;
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  /** One number, or three for a vector. */
  readonly default: readonly number[];
  /** What a newly added item has instead of the default. */
  readonly start?: number;
  readonly whole: boolean;
  /** Names of the whole numbers from 0 on; empty where it is a quantity. */
  readonly names: readonly string[];
  readonly label: string;
  readonly text: string;
}

interface List {
  readonly label: string;
  readonly fields: readonly Field[];
}

/** The density over life is a list for the simulator and a curve for people: `emission.density`. */
const { density: _curve, ...lists }: Readonly<Record<string, List>> = source;

/** Names of the lists in their order. */
export const listNames: readonly string[] = Object.keys(lists);

/** What people call an item: 'Vortex 2' for the second of the vortices. */
export function itemLabel(list: string, index: number): string {
  return `${lists[list].label} ${index + 1}`;
}

/** What people call one item of a list. */
export function listLabel(list: string): string {
  return lists[list].label;
}

/** Flat values that bring item `index` of a list into being so that it does something. */
export function startValues(list: string, index: number): Record<string, number> {
  const { fields } = lists[list];
  const starting = fields.filter(({ start }) => start !== undefined);
  const chosen = starting.length > 0 ? starting : fields.filter((field) => field.names.length === 0).slice(0, 1);
  return Object.fromEntries(
    chosen.map((field) => [`${list}.${index}.${field.key}${endsOf(field)[0]}`, field.start ?? field.default[0]]),
  );
}

/** Every row of every item of every list. */
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

function unitOf(unit: string): string {
  return unit === '1' ? '' : unit.replace(/(?<=[a-z])[23]/g, (power) => (power === '2' ? '\u00b2' : '\u00b3'));
}

/** A few hundred steps for small ranges; large ones are stepped through near zero, where most values lie. */
function stepOf(span: number): number {
  return span <= 5 ? 0.01 : 0.05;
}

/** 'cone nozzle' of `coneNozzle`, with a capital. */
function sentence(name: string): string {
  const words = name.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
  return words[0].toUpperCase() + words.slice(1);
}
