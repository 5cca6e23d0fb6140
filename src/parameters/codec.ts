/**
 * Encodes the state as the hash of a share link and decodes it: `#v=1&preset=lamp&emission.rate=240`.
 *
 * A link contains the values that differ from its preset, in the order of the table. Links are untrusted: decoding
 * never throws and reports invalid parts as notices. The result has a valid value for every key that is not optional.
 */
import { migrate, VERSION, versionOf } from './migrations.ts';
import { notice, quoteKey, summarise, type Notice } from './notice.ts';
import { DECODED_LIMIT, pack, packBytes, unpack, unpackBytes } from './packing.ts';
import type { AnyValues, Parameter, ShareLink, Value, Values } from './parameter.ts';
import { defaultPreset, findPreset, presetValues } from './presets.ts';
import { findParameter, table } from './table.ts';
import { cleanTimeline } from './timeline.ts';
import type { PresetName } from './valueTypes.ts';
import { readText, writeText } from './values.ts';

/** Content of a link: a preset and a value for every parameter that is not optional. */
export interface State {
  readonly preset: PresetName;
  readonly values: Values;
}

/** A decoded link. */
export interface Decoded {
  readonly state: State;
  /** Bytes of a take that leads to the shared moment. Only the simulator can validate them. */
  readonly take?: Uint8Array;
  readonly notices: readonly Notice[];
}

const LONGEST_READABLE = 1500;

/** Maximum length of a shared link in characters. Chat and mail programs truncate longer links; use a file instead. */
export const LONGEST_LINK = 8000;

/** The state without a link: the default preset. */
export function defaultState(): State {
  return { preset: defaultPreset.name, values: presetValues(defaultPreset) };
}

/**
 * Encodes a state as a URL hash, with `#`. Compresses it if the readable form exceeds 1,500 characters.
 * @param take bytes of a take, for a link to a moment
 */
export async function encode(state: State, take?: Uint8Array<ArrayBuffer>): Promise<ShareLink> {
  const text = writeState(state);
  const shown: ShareLink = text.length <= LONGEST_READABLE ? `#${text}` : `#v=${VERSION}&z=${await pack(text)}`;
  return take ? `${shown}&take=${await packBytes(take)}` : shown;
}

/** Decodes a URL hash, with or without `#`. What hosts append, such as `#?secret=` or `:~:text=`, ends it. Never rejects. */
export async function decode(hash: string): Promise<Decoded> {
  const notices: Notice[] = [];
  const text = await expand(hash.replace(/^#/, '').split(/[#?]|:~:/, 1)[0], notices);
  const pairs = firstOfEach(new URLSearchParams(text), notices);
  const state = readState(pairs, notices, 'link');
  const take = await readTake(pairs.get('take'), notices);
  return { state, ...(take && { take }), notices: summarise(notices) };
}

function writeState({ preset, values }: State): string {
  const differing = ownValues({ preset, values });
  const pairs = differing.map(([parameter, value]) => `${parameter.key}=${writeText(parameter, value)}`);
  return [`v=${VERSION}`, `preset=${preset}`, ...pairs].join('&');
}

/** Values that differ from the preset, in the order of the table. */
export function ownValues({ preset, values: given }: State): [Parameter, Value][] {
  const values: AnyValues = given;
  const base: AnyValues = presetValues(findPreset(preset) ?? defaultPreset);
  const differing = table.filter(({ key }) => values[key] !== undefined && values[key] !== base[key]);
  return differing.map((parameter) => [parameter, values[parameter.key]]);
}

/** Decompresses a packed link and appends pairs that were added to it by hand. */
async function expand(text: string, notices: Notice[]): Promise<string> {
  const outer = new URLSearchParams(cut(text, text.length > DECODED_LIMIT, notices));
  const packed = outer.get('z');
  if (packed === null) return outer.toString();
  outer.delete('z');
  try {
    const inner = await unpack(packed);
    if (new URLSearchParams(inner.text).has('v')) outer.delete('v');
    return `${cut(inner.text, inner.isCut, notices)}&${outer}`;
  } catch {
    const sentence = () => 'The link is damaged: its packed part cannot be read. Copy the whole link.';
    notices.push(notice('damaged', 'z', packed, sentence));
    return outer.toString();
  }
}

/** Truncates overlong text after the last complete pair within the limit. */
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

/** Keys of a link that are not parameters. */
const OWN_KEYS: ReadonlySet<string> = new Set(['v', 'preset', 'take']);

/**
 * Parses the pairs of a link or a file of any version. Never throws.
 * @param notices receives a notice for each pair that is ignored or changed
 */
export function readState(given: ReadonlyMap<string, string>, notices: Notice[], source: 'link' | 'file'): State {
  const pairs = migrate(given);
  const version = versionOf(pairs);
  if (version !== VERSION) notices.push(notice('version', 'v', version, versionSentence));
  const name = pairs.get('preset') ?? defaultPreset.name;
  const found = findPreset(name);
  if (!found) notices.push(notice('unknownPreset', 'preset', name, presetSentence));
  const preset = found ?? defaultPreset;
  const values: Record<string, Value> = { ...presetValues(preset) };
  for (const [key, text] of pairs) {
    if (!OWN_KEYS.has(key)) readPair(key, text, values, notices, source);
  }
  return { preset: preset.name, values };
}

function readPair(
  key: string,
  text: string,
  values: Record<string, Value>,
  notices: Notice[],
  source: 'link' | 'file',
): void {
  const parameter = findParameter(key);
  if (!parameter) {
    const sentence =
      key === 'model' && source === 'link'
        ? 'A link cannot contain a model.'
        : `There is no parameter ${quoteKey(key)}; it was ignored.`;
    notices.push(notice('unknownKey', key, text, () => sentence));
    return;
  }
  const read = readText(parameter, text, values[parameter.key], source);
  values[parameter.key] = parameter.kind === 'timeline' ? cleanTimeline(String(read.value), notices) : read.value;
  if (read.notice) notices.push(read.notice);
}

function versionSentence(given: string): string {
  return `This page reads version ${VERSION}, not ${given}; unknown parts are ignored.`;
}

function presetSentence(given: string): string {
  return `There is no preset ${given}; \u201c${defaultPreset.name}\u201d is shown.`;
}
