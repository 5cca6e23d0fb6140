import { notice, summarise, type Notice } from '../../../parameters/notice.ts';
import type { Value, Values } from '../../../parameters/parameter.ts';
import { fetchPreset, FIRST_PRESET } from '../../../parameters/byScene/fetchPreset.ts';
import { findParameter } from '../../../parameters/table.ts';
import { presetValues, readText } from '../../../parameters/values.ts';
import { keyOfAttribute } from './names.ts';
import { part, presetOf } from '../parts.ts';
import type { Base } from './link.ts';
import { EMIT_ON } from './properties.ts';

/** The state that the attributes of an element describe. */
export interface ParsedAttributes extends Base {
  /** Attribute values that were corrected or ignored. */
  readonly notices: readonly Notice[];
}

/** Allowed values of attributes that are not parameters. The first one is the default. */
const CHOICES = [
  ['thread', ['auto', 'main', 'worker']],
  ['loading', ['lazy', 'eager']],
  ['emit-on', EMIT_ON],
] as const;

/**
 * Reads `src`, `preset`, `start` and the parameters. A link takes precedence over a preset, CSS properties over both, and
 * parameter attributes override all. Attributes have the same limits as links, because many pages let untrusted users write
 * them.
 * @param ofCss values that CSS properties set
 * @throws LoadError when the parser of links or of timelines cannot be fetched
 */
export async function parseAttributes(element: Element, ofCss: Values): Promise<ParsedAttributes> {
  const notices: Notice[] = [];
  const base = await readBase(element, notices);
  const values: Record<string, Value> = { ...base.values, ...ofCss };
  for (const { name, value } of element.attributes) {
    const parameter = findParameter(keyOfAttribute.get(name) ?? '');
    if (!parameter) continue;
    const read = readText(parameter, value, values[parameter.key]);
    values[parameter.key] = read.value;
    if (read.notice) notices.push(read.notice);
  }
  if (element.hasAttribute('timeline'))
    values.timeline = (await part('timeline')).cleanTimeline(String(values.timeline), notices);
  for (const [name, options] of CHOICES) readChoice(element, name, options, notices);
  const start = element.getAttribute('start');
  return {
    ...base,
    values,
    start: start === null ? base.start : (await part('link')).readStart(start, notices),
    notices: summarise(notices),
  };
}

async function readBase(element: Element, notices: Notice[]): Promise<Base> {
  const link = element.getAttribute('src');
  if (link !== null) return (await part('link')).readLink(link, element.baseURI, notices);
  const name = element.getAttribute('preset');
  const preset = await presetOf(element);
  if (!preset && name !== null) {
    const sentence = (given: string) => `There is no preset ${given}; \u201c${FIRST_PRESET}\u201d is shown.`;
    notices.push(notice('unknownPreset', 'preset', name, sentence));
  }
  const values = presetValues(preset ?? (await fetchPreset(FIRST_PRESET))!);
  return { link, values, start: undefined, isPaused: false, take: undefined };
}

function readChoice(element: Element, name: string, options: readonly string[], notices: Notice[]): void {
  const given = element.getAttribute(name);
  if (given === null || options.includes(given)) return;
  const sentence = (quoted: string) =>
    `${name} cannot be ${quoted}: it takes ${options.join(', ')}. ${options[0]} is used.`;
  notices.push(notice('malformed', name, given, sentence));
}
