/**
 * Parameter table rows of the simulator's lists (emitters, vortices, winds and so on), such as
 * `vortices.0.circulation`. The simulator defines the fields of a list and generates lists.json (see
 * sim-wasm/sim/tests/simulator/page_table.rs).
 *
 * These rows are optional: a parameter without a value has the scene's value.
 */
import source from './lists.json' with { type: 'json' };
import { MAX_STOPS } from './curve.ts';
import type {
  ChoiceParameter,
  CurveParameter,
  NumberParameter,
  OutlineParameter,
  PathParameter,
  RampParameter,
} from './parameter.ts';
import { choice, fixed, ofScene, quantity, unitOf } from './rows/row.ts';

/** Maximum number of items per list, as in the simulator. */
export const LIST_LIMIT = 8;

/** A parameter of each item of a list. */
export interface Field {
  readonly key: string;
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  /** One number, three for a vector, one for each stop of a curve or point of a path, or none for an outline. */
  readonly default: readonly number[];
  readonly whole: boolean;
  /** Names of the values 0, 1, ...; empty for a quantity. */
  readonly names: readonly string[];
}

/** Excludes density over life, a list in the simulator that users edit as a curve: `emission.density`. */
const { density: _curve, ...others }: Readonly<Record<string, readonly Field[]>> = source;

/** The fields of each list. */
export const lists: Readonly<Record<string, readonly Field[]>> = others;

/** Names of the lists in order. */
export const listNames: readonly string[] = Object.keys(lists);

/** The number of an emitter that stands for the colours and the ink of its look. */
export const LOOK_STYLE = 'look.style';

type ItemParameter =
  NumberParameter | ChoiceParameter | CurveParameter | PathParameter | OutlineParameter | RampParameter;

/** All rows of all items of all lists. */
export function listParameters(): ItemParameter[] {
  return listNames.flatMap((name) =>
    Array.from({ length: LIST_LIMIT }, (_, index) => itemParameters(name, index)).flat(),
  );
}

function itemParameters(list: string, index: number): ItemParameter[] {
  return lists[list].flatMap((field) => {
    const rows = fieldParameters(field, `${list}.${index}`);
    return field.key.startsWith('look.') ? rows.map((row) => fixed('looks', row)) : rows;
  });
}

function fieldParameters(field: Field, item: string): ItemParameter[] {
  const key = `${item}.${field.key}`;
  if (field.key === LOOK_STYLE) return lookStyle(`${item}.look`);
  if (field.default.length === 0)
    return [ofScene({ kind: 'outline', key, reader: 'simulator', fixed: 'simulation', default: '' } as const)];
  if (isText(field)) return [ofScene({ kind: kindOf(field), key, reader: 'simulator', default: '' } as const)];
  return endsOf(field).map((end, part) =>
    field.names.length > 0 ? choiceOf(field, key + end) : numberOf(field, part, key + end),
  );
}

/** The colours and the ink of a look, which the style reads. */
function lookStyle(look: string): ItemParameter[] {
  const ramp = (name: string): RampParameter =>
    ofScene({ kind: 'ramp', key: `${look}.${name}`, reader: 'style', default: '' } as const);
  const ink = quantity(`${look}.inkWeight`, 'style', { min: 0, max: 4, default: 1 });
  return [ramp('colors'), ramp('ageColors'), ramp('heatColors'), ofScene(ink)];
}

/** Whether a field holds the stops of a curve or the points of a path, which is one text in the table. */
function isText(field: Field): boolean {
  return field.default.length >= MAX_STOPS;
}

function kindOf(field: Field): 'curve' | 'path' {
  return field.default.length === MAX_STOPS ? 'curve' : 'path';
}

/** The ends of the keys of a field: one, one for each axis of a vector, or one for each stop or point of a text. */
export function endsOf(field: Field): readonly string[] {
  if (isText(field)) return field.default.map((_, stop) => `.${stop}`);
  return field.default.length < 3 ? [''] : ['.x', '.y', '.z'];
}

function choiceOf({ names, default: [initial] }: Field, key: string): ChoiceParameter {
  return ofScene(choice(key, 'simulator', names[initial], names));
}

function numberOf({ whole, unit, min, max, default: initial }: Field, part: number, key: string): NumberParameter {
  const kind = whole ? 'integer' : 'number';
  return ofScene(quantity(key, 'simulator', { kind, unit: unitOf(unit), min, max, default: initial[part] }));
}
