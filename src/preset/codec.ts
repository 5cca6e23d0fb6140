/**
 * The share link: state to the hash of an address and back, `#v=1&preset=lamp&emission.rate=240`.
 *
 * A link holds what differs from its preset, in the order of the table. Reading one never throws and never trusts:
 * what cannot be used is told in notices, and the result always has a value in range for every key that needs one.
 */
import { migrate, VERSION } from './migrations.ts';
import { notice, quoteKey, summarise, type Notice } from './notice.ts';
import { DECODED_LIMIT, pack, packBytes, unpack, unpackBytes } from './packing.ts';
import type { Parameter, Value, Values } from './parameter.ts';
import { defaultPreset, findPreset, presetValues } from './presets.ts';
import { findParameter, table } from './table.ts';
import { readText, writeText } from './values.ts';

/** What a link carries: a preset and a value for every key of the table that is not optional. */
export interface State {
  readonly preset: string;
  readonly values: Values;
}

/** A link read: what to show, and what to tell. */
export interface Decoded {
  readonly state: State;
  /** Bytes of a take that leads to the moment that was shared; whether they are one, only a simulator can say. */
  readonly take?: Uint8Array;
  readonly notices: readonly Notice[];
}

const LONGEST_READABLE = 1500;

/** What is longer is not sent as a link, because chats and mail programs cut it: it becomes a file. */
export const LONGEST_LINK = 8000;

/** The preset that is shown when nothing else is asked for. */
export function defaultState(): State {
  return { preset: defaultPreset.name, values: presetValues(defaultPreset) };
}

/**
 * The hash of a state, with `#`; packed when the readable form is over 1,500 characters.
 * @param take bytes of a take, for a link to one very moment
 */
export async function encode(state: State, take?: Uint8Array<ArrayBuffer>): Promise<string> {
  const text = writeState(state);
  const shown = text.length <= LONGEST_READABLE ? `#${text}` : `#v=${VERSION}&z=${await pack(text)}`;
  return take ? `${shown}&take=${await packBytes(take)}` : shown;
}

/** Reads the hash of an address, with or without `#`. Never rejects. */
export async function decode(hash: string): Promise<Decoded> {
  const notices: Notice[] = [];
  const text = await expand(hash.replace(/^#/, ''), notices);
  const pairs = migrate(firstOfEach(new URLSearchParams(text), notices), notices);
  const state = readState(pairs, notices, 'link');
  const take = await readTake(pairs.get('take'), notices);
  return { state, ...(take && { take }), notices: summarise(notices) };
}

function writeState({ preset, values }: State): string {
  const differing = ownValues({ preset, values });
  const pairs = differing.map(([parameter, value]) => `${parameter.key}=${writeText(parameter, value)}`);
  return [`v=${VERSION}`, `preset=${preset}`, ...pairs].join('&');
}

/** What a state has otherwise than its preset, in the order of the table. */
export function ownValues({ preset, values }: State): [Parameter, Value][] {
  const base = presetValues(findPreset(preset) ?? defaultPreset);
  const differing = table.filter(({ key }) => values[key] !== undefined && values[key] !== base[key]);
  return differing.map((parameter) => [parameter, values[parameter.key]]);
}

/** The readable form of a packed link, followed by what somebody may have written behind it by hand. */
async function expand(text: string, notices: Notice[]): Promise<string> {
  const outer = new URLSearchParams(cut(text, text.length > DECODED_LIMIT, notices));
  const packed = outer.get('z');
  if (packed === null) return outer.toString();
  outer.delete('z');
  outer.delete('v');
  try {
    const inner = await unpack(packed);
    return `${cut(inner.text, inner.isCut, notices)}&${outer}`;
  } catch {
    const sentence = () => 'The link is damaged: its packed part cannot be read. Copy the whole link.';
    notices.push(notice('damaged', 'z', packed, sentence));
    return outer.toString();
  }
}

/** Drops what lies beyond the limit, and the pair that the limit would cut in two. */
function cut(text: string, isTooLong: boolean, notices: Notice[]): string {
  if (!isTooLong) return text;
  notices.push(notice('tooLong', '', '', () => 'The link is too long; its end was ignored.'));
  return text.slice(0, Math.max(0, text.lastIndexOf('&', DECODED_LIMIT)));
}

function firstOfEach(pairs: URLSearchParams, notices: Notice[]): Map<string, string> {
  const first = new Map<string, string>();
  for (const [key, text] of pairs) {
    if (!first.has(key)) first.set(key, text);
    else
      notices.push(notice('duplicate', key, text, () => `${quoteKey(key)} is in the link twice; the first is used.`));
  }
  return first;
}

async function readTake(packed: string | undefined, notices: Notice[]): Promise<Uint8Array | undefined> {
  if (packed === undefined) return undefined;
  const inflated = await unpackBytes(packed, DECODED_LIMIT).catch(() => undefined);
  if (inflated && !inflated.isCut) return inflated.bytes;
  const sentence = () => 'The moment in the link is damaged; the smoke starts from the beginning.';
  notices.push(notice('damaged', 'take', packed, sentence));
  return undefined;
}

/** Keys of a link that are no parameters. */
const OWN_KEYS: ReadonlySet<string> = new Set(['v', 'preset', 'take']);

/**
 * The state that pairs of text describe, those of a link or of a file, after `migrate`.
 * @param notices notified of everything that is not used as it stands
 */
export function readState(pairs: ReadonlyMap<string, string>, notices: Notice[], source: 'link' | 'file'): State {
  const version = pairs.get('v') ?? VERSION;
  if (version !== VERSION) notices.push(notice('version', 'v', version, versionSentence));
  const name = pairs.get('preset') ?? defaultPreset.name;
  const preset = findPreset(name);
  if (!preset) notices.push(notice('unknownPreset', 'preset', name, presetSentence));
  const values = presetValues(preset ?? defaultPreset);
  for (const [key, text] of pairs) {
    if (!OWN_KEYS.has(key)) readPair(key, text, values, notices, source);
  }
  return { preset: (preset ?? defaultPreset).name, values };
}

function readPair(
  key: string,
  text: string,
  values: Record<string, Values[string]>,
  notices: Notice[],
  source: 'link' | 'file',
): void {
  const parameter = findParameter(key);
  if (!parameter) {
    notices.push(notice('unknownKey', key, text, () => `There is no parameter ${quoteKey(key)}; it was ignored.`));
    return;
  }
  const read = readText(parameter, text, values[parameter.key], source);
  values[parameter.key] = read.value;
  if (read.notice) notices.push(read.notice);
}

function versionSentence(given: string): string {
  return `This page reads version ${VERSION}, not ${given}; unknown parts are ignored.`;
}

function presetSentence(given: string): string {
  return `There is no preset ${given}; \u201c${defaultPreset.name}\u201d is shown.`;
}
