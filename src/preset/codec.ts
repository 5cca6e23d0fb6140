/**
 * The share link: state to the hash of an address and back, `#v=1&preset=lamp&emission.rate=240`.
 *
 * A link holds what differs from its preset, in the order of the table. Reading one never throws and never trusts:
 * what cannot be used is told in notices, and the result always has a value in range for every key that needs one.
 */
import { notice, quoteKey, summarise, type Notice } from './notice.ts';
import { DECODED_LIMIT, pack, unpack } from './packing.ts';
import type { Values } from './parameter.ts';
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
  readonly notices: readonly Notice[];
}

const VERSION = '1';
const LONGEST_READABLE = 1500;

/** The preset that is shown when nothing else is asked for. */
export function defaultState(): State {
  return { preset: defaultPreset.name, values: presetValues(defaultPreset) };
}

/** The hash of a state, with `#`; packed when the readable form is over 1,500 characters. */
export async function encode(state: State): Promise<string> {
  const text = writeState(state);
  if (text.length <= LONGEST_READABLE) return `#${text}`;
  return `#v=${VERSION}&z=${await pack(text)}`;
}

/** Reads the hash of an address, with or without `#`. Never rejects. */
export async function decode(hash: string): Promise<Decoded> {
  const notices: Notice[] = [];
  const text = await expand(hash.replace(/^#/, ''), notices);
  const state = readState(firstOfEach(new URLSearchParams(text), notices), notices);
  return { state, notices: summarise(notices) };
}

function writeState({ preset, values }: State): string {
  const base = presetValues(findPreset(preset) ?? defaultPreset);
  const differing = table.filter(({ key }) => values[key] !== undefined && values[key] !== base[key]);
  const pairs = differing.map((parameter) => `${parameter.key}=${writeText(parameter, values[parameter.key])}`);
  return [`v=${VERSION}`, `preset=${preset}`, ...pairs].join('&');
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
    const tell = () => 'The link is damaged: its packed part cannot be read. It may have been cut when it was copied.';
    notices.push(notice('damaged', 'z', packed, tell));
    return outer.toString();
  }
}

/** Drops what lies beyond the limit, and the pair that the limit would cut in two. */
function cut(text: string, isTooLong: boolean, notices: Notice[]): string {
  if (!isTooLong) return text;
  notices.push(notice('tooLong', '', '', () => 'The link is too long; only its beginning was read.'));
  return text.slice(0, Math.max(0, text.lastIndexOf('&', DECODED_LIMIT)));
}

function firstOfEach(pairs: URLSearchParams, notices: Notice[]): Map<string, string> {
  const first = new Map<string, string>();
  for (const [key, text] of pairs) {
    if (!first.has(key)) first.set(key, text);
    else
      notices.push(
        notice('duplicate', key, text, () => `${quoteKey(key)} stands twice in the link; the first is used.`),
      );
  }
  return first;
}

function readState(pairs: Map<string, string>, notices: Notice[]): State {
  const version = pairs.get('v') ?? VERSION;
  if (version !== VERSION) notices.push(notice('version', 'v', version, tellVersion));
  const name = pairs.get('preset') ?? defaultPreset.name;
  const preset = findPreset(name);
  if (!preset) notices.push(notice('unknownPreset', 'preset', name, tellPreset));
  const values = presetValues(preset ?? defaultPreset);
  for (const [key, text] of pairs) {
    if (key !== 'v' && key !== 'preset') readPair(key, text, values, notices);
  }
  return { preset: (preset ?? defaultPreset).name, values };
}

function readPair(key: string, text: string, values: Record<string, Values[string]>, notices: Notice[]): void {
  const parameter = findParameter(key);
  if (!parameter) {
    notices.push(notice('unknownKey', key, text, () => `There is no parameter ${quoteKey(key)}; it was ignored.`));
    return;
  }
  const read = readText(parameter, text, values[parameter.key]);
  values[parameter.key] = read.value;
  if (read.notice) notices.push(read.notice);
}

function tellVersion(given: string): string {
  return `The link has version ${given}, this page reads version ${VERSION}; what it knows was used.`;
}

function tellPreset(given: string): string {
  return `There is no preset ${given}; \u201c${defaultPreset.name}\u201d is shown.`;
}
