/**
 * The names of all parameters as attributes (`emission-rate`) and as properties (`emissionRate`). The parameter table
 * with its ranges and texts is loaded with the smoke. Before that, the element has only the names from names.json,
 * which a test compares with the table.
 */
import listed from './names.json' with { type: 'json' };

export interface Name {
  /** Key in the parameter table, such as `emission.rate`. */
  readonly key: string;
  readonly attribute: string;
  readonly property: string;
  /**
   * Whether the values are strings (words, colours or colour stops) that are passed on unparsed; otherwise they are
   * numbers.
   */
  readonly isText: boolean;
}

const LIST_LIMIT = 8;

/** Every parameter, in the order of the table. */
export const names: readonly Name[] = Object.entries(listed).flatMap(([list, fields]) =>
  list === ''
    ? namesOf('', fields)
    : Array.from({ length: LIST_LIMIT }, (_, index) => namesOf(`${list}.${index}.`, fields)).flat(),
);

/** Maps each attribute to its key. */
export const keyOfAttribute: ReadonlyMap<string, string> = new Map(names.map(({ attribute, key }) => [attribute, key]));

/** @param fields space-separated keys; `$` marks a string, `.xyz` a vector */
function namesOf(prefix: string, fields: string): Name[] {
  return fields.split(' ').flatMap((field) => {
    const isText = field.endsWith('$');
    const stem = prefix + (isText ? field.slice(0, -1) : field);
    const keys = stem.endsWith('.xyz') ? ['x', 'y', 'z'].map((axis) => stem.slice(0, -3) + axis) : [stem];
    return keys.map((key) => ({ key, attribute: attributeOf(key), property: camelCase(key), isText }));
  });
}

function attributeOf(key: string): string {
  return key.replaceAll('.', '-').replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
}

/** @param name words separated by dots or hyphens */
export function camelCase(name: string): string {
  return name.replace(/[.-](.)/g, (_, letter: string) => letter.toUpperCase());
}
