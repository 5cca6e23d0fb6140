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

/** Indices of the items of a list. */
const INDICES = '01234567';

/** Every parameter, in the order of the table. */
export const names: readonly Name[] = Object.entries(listed).flatMap(([list, fields]) => {
  // Pages wait for the names, so those of a list are made once for all of its items.
  const ofItem = JSON.stringify(namesOf(list && `${list}.#.`, fields));
  return (list ? INDICES : '0').split('').flatMap((index) => JSON.parse(ofItem.replaceAll('#', index)) as Name[]);
});

/** Maps each attribute to its key. */
export const keyOfAttribute: ReadonlyMap<string, string> = new Map(names.map(({ attribute, key }) => [attribute, key]));

/** @param fields space-separated keys; `$` marks a string, `.xyz` a vector */
function namesOf(prefix: string, fields: string): Name[] {
  return fields.split(' ').flatMap((field) => {
    const isText = field.endsWith('$');
    const stem = prefix + field.replace('$', '');
    const keys = stem.endsWith('.xyz') ? 'xyz'.split('').map((axis) => stem.replace('xyz', axis)) : [stem];
    return keys.map((key) => ({ key, attribute: attributeOf(key), property: camelCase(key), isText }));
  });
}

function attributeOf(key: string): string {
  return key.replaceAll('.', '-').replace(/[A-Z]/g, '-$&').toLowerCase();
}

/** @param name words separated by dots or hyphens */
export function camelCase(name: string): string {
  return name.replace(/[.-](.)/g, (_, letter: string) => letter.toUpperCase());
}
