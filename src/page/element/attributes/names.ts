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
export const names: readonly Name[] = Object.entries(listed).flatMap(([list, fields]) => {
  const named = namesOf(fields, list === '');
  if (list === '') return named;
  return Array.from({ length: LIST_LIMIT }, (_, index) => named.map((name) => ofItem(name, list, index))).flat();
});

/** Maps each attribute to its key. */
export const keyOfAttribute: ReadonlyMap<string, string> = new Map(names.map(({ attribute, key }) => [attribute, key]));

/**
 * @param fields space-separated keys; `$` marks a string, `.xyz` a vector
 * @param isFirst whether a property begins with a field, and not with the name of a list
 */
function namesOf(fields: string, isFirst: boolean): Name[] {
  return fields.split(' ').flatMap((field) => {
    const isText = field.endsWith('$');
    const stem = isText ? field.slice(0, -1) : field;
    const keys = stem.endsWith('.xyz') ? ['x', 'y', 'z'].map((axis) => stem.slice(0, -3) + axis) : [stem];
    return keys.map((key) => ({ key, attribute: attributeOf(key), property: propertyOf(key, isFirst), isText }));
  });
}

/** Pages wait for these names, so the words of a field are not read again for each item. */
function ofItem({ key, attribute, property, isText }: Name, list: string, index: number): Name {
  return {
    key: `${list}.${index}.${key}`,
    attribute: `${attributeOf(list)}-${index}-${attribute}`,
    property: `${list}${index}${property}`,
    isText,
  };
}

function attributeOf(key: string): string {
  return key.replaceAll('.', '-').replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
}

function propertyOf(key: string, isFirst: boolean): string {
  const parts = key.split('.').map((part, at) => (at === 0 && isFirst ? part : part[0].toUpperCase() + part.slice(1)));
  return parts.join('');
}
