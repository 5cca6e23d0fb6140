import { decode } from '../preset/codec.ts';
import { readEnvironment } from '../preset/environment.ts';
import { notice, summarise, type Notice } from '../preset/notice.ts';
import type { Values } from '../preset/parameter.ts';
import { defaultPreset, findPreset, presetValues } from '../preset/presets.ts';
import { findParameter } from '../preset/table.ts';
import { readText } from '../preset/values.ts';
import { EMIT_ON } from './emitterSwitch.ts';
import { keyOfAttribute } from './names.ts';

/** What an element asks for by its attributes. */
export interface Wish {
  readonly values: Values;
  /** Simulated seconds before the first picture. */
  readonly start: number | undefined;
  /** Whether the link shows something still. */
  readonly isPaused: boolean;
  /** Bytes of a take out of a share link, which leads to one moment. */
  readonly take: Uint8Array | undefined;
  /** What was not taken as it stands. */
  readonly notices: readonly Notice[];
}

/** What attributes take that are no parameters; the first is what holds without one. */
const CHOICES = [
  ['thread', ['auto', 'main', 'worker']],
  ['loading', ['lazy', 'eager']],
  ['emit-on', EMIT_ON],
] as const;

/**
 * Reads `src`, `preset`, `start` and the parameters: a link, or else a preset, and over it each parameter by itself.
 * Never rejects. Attributes may ask for no more than links, because on many pages strangers can write them.
 */
export async function readWish(element: Element): Promise<Wish> {
  const notices: Notice[] = [];
  const base = await readBase(element, notices);
  const values = { ...base.values };
  for (const { name, value } of element.attributes) {
    const parameter = findParameter(keyOfAttribute.get(name) ?? '');
    if (!parameter) continue;
    const read = readText(parameter, value, values[parameter.key]);
    values[parameter.key] = read.value;
    if (read.notice) notices.push(read.notice);
  }
  for (const [name, options] of CHOICES) readChoice(element, name, options, notices);
  const start = element.getAttribute('start');
  return {
    ...base,
    values,
    start: start === null ? base.start : readStart(start, notices),
    notices: summarise(notices),
  };
}

type Base = Omit<Wish, 'notices'>;

/** What the parameters stand over. */
async function readBase(element: Element, notices: Notice[]): Promise<Base> {
  const link = element.getAttribute('src');
  if (link !== null) return readLink(link, element.baseURI, notices);
  const name = element.getAttribute('preset');
  // The first preset of a scene has its name, and shows it as it wants to be seen.
  const preset = findPreset(name ?? element.getAttribute('scene') ?? '');
  if (!preset && name !== null) {
    const tell = (given: string) => `There is no preset ${given}; \u201c${defaultPreset.name}\u201d is shown.`;
    notices.push(notice('unknownPreset', 'preset', name, tell));
  }
  return { values: presetValues(preset ?? defaultPreset), start: undefined, isPaused: false, take: undefined };
}

async function readLink(link: string, base: string, notices: Notice[]): Promise<Base> {
  const { hash, search } = addressOf(link, base, notices);
  const { state, take, notices: ofHash } = await decode(hash);
  const { time, paused, notices: ofQuery } = readEnvironment(search);
  notices.push(...ofHash, ...ofQuery);
  return { values: state.values, start: time, isPaused: paused, take };
}

function addressOf(link: string, base: string, notices: Notice[]): Pick<URL, 'hash' | 'search'> {
  try {
    return new URL(link, base);
  } catch {
    notices.push(notice('damaged', 'src', link, (given) => `src cannot be ${given}: it takes a share link.`));
    return { hash: '', search: '' };
  }
}

/** Reads the start as the query of a link is read. */
function readStart(text: string, notices: Notice[]): number | undefined {
  const { time, notices: told } = readEnvironment(`?${new URLSearchParams({ t: text })}`);
  notices.push(...told);
  return time;
}

function readChoice(element: Element, name: string, options: readonly string[], notices: Notice[]): void {
  const given = element.getAttribute(name);
  if (given === null || options.includes(given)) return;
  const tell = (quoted: string) =>
    `${name} cannot be ${quoted}: it takes ${options.join(', ')}. ${options[0]} is used.`;
  notices.push(notice('malformed', name, given, tell));
}
