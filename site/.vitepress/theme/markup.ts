/** Reads what a person types beside a live example. Nothing of it is evaluated or becomes HTML. */

export type Attributes = ReadonlyMap<string, string>;
export type Values = Readonly<Record<string, number | string>>;

const ATTRIBUTE = /\s+([a-z][\w-]*)(?:\s*=\s*(?:"([^"<]*)"|'([^'<]*)'|([^\s"'<>=`]+)))?/gi;
const ELEMENT = new RegExp(`^\\s*<cartoon-smoke((?:${ATTRIBUTE.source})*)\\s*>([^<]*)(?:</cartoon-smoke>)?\\s*$`, 'i');
const CHARACTERS: Readonly<Record<string, string>> = { amp: '&', lt: '<', gt: '>', quot: '"', '#39': "'" };

/**
 * The attributes of one `<cartoon-smoke>`, without those that only place it in a page.
 *
 * @throws {SyntaxError} with a sentence for the person
 */
export function readElement(text: string): Attributes {
  const given = ELEMENT.exec(text)?.[1];
  if (given === undefined) throw new SyntaxError('Write one <cartoon-smoke> with attributes such as preset="wisp".');
  const attributes = new Map<string, string>();
  for (const [, name, double, single, bare] of given.matchAll(ATTRIBUTE)) {
    const key = name.toLowerCase();
    if (key !== 'style' && !attributes.has(key)) attributes.set(key, decoded(double ?? single ?? bare ?? ''));
  }
  return attributes;
}

/**
 * Values by key, as JSON.
 *
 * @throws {SyntaxError} with a sentence for the person
 */
export function readValues(text: string): Values {
  const sentence = 'Write values as JSON, such as { "emission.rate": 24 }.';
  let given: unknown;
  try {
    given = JSON.parse(text);
  } catch {
    throw new SyntaxError(sentence);
  }
  if (typeof given !== 'object' || given === null || Array.isArray(given)) throw new SyntaxError(sentence);
  const wrong = Object.entries(given).find(([, value]) => typeof value !== 'number' && typeof value !== 'string');
  if (wrong) throw new SyntaxError(`${wrong[0]} is a number or a text.`);
  return given as Values;
}

function decoded(text: string): string {
  return text.replace(/&(amp|lt|gt|quot|#39);/g, (_, name: string) => CHARACTERS[name]);
}
