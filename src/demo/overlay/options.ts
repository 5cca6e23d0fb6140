/** The query of `overlay.html`: what starts the smoke, and for how long it plays. */
import { notice, readTime } from '../../internal.ts';
import type { Notice } from '../../preset.ts';

/** What starts the smoke: a key by its name, a message from another window, or a message of a local web socket. */
export type Trigger =
  | { readonly kind: 'key'; readonly name: string }
  | { readonly kind: 'message' }
  | { readonly kind: 'socket'; readonly address: string };

export interface OverlayOptions {
  /** Without any, smoke plays at once. */
  readonly triggers: readonly Trigger[];
  /** Simulated seconds in which smoke is emitted; infinite by default if smoke plays at once. */
  readonly seconds: number;
  /** Whether smoke waits for a trigger, also if all triggers of the query are invalid. */
  readonly waits: boolean;
  /** Whether the page shows messages. */
  readonly explains: boolean;
  /** What is invalid in the query. */
  readonly notices: readonly Notice[];
}

/** Duration of a play in simulated seconds. */
const SECONDS = 5;
/** Hosts that are always this machine. A Content Security Policy cannot name the address of version 6. */
const LOOPBACK: readonly string[] = ['127.0.0.1', 'localhost'];
const LONGEST_NAME = 20;

/** Reads a query, with or without `?`. Never throws. */
export function readOptions(search: string): OverlayOptions {
  const query = new URLSearchParams(search);
  const notices: Notice[] = [];
  const texts = query.getAll('trigger');
  const triggers = texts.flatMap((text) => {
    const trigger = readTrigger(text);
    const sentence = (quoted: string) =>
      `trigger cannot be ${quoted}: it takes key:F9, message, or a web socket of this machine, ws://127.0.0.1:PORT.`;
    if (!trigger) notices.push(notice('malformed', 'trigger', text, sentence));
    return trigger ?? [];
  });
  const seconds = readTime(query.get('seconds'), notices, 'seconds');
  return {
    triggers,
    seconds: seconds ?? (texts.length > 0 ? SECONDS : Number.POSITIVE_INFINITY),
    waits: texts.length > 0,
    explains: query.get('ui') === '1',
    notices,
  };
}

function readTrigger(text: string): Trigger | undefined {
  const [, name] = /^key:(\S+)$/.exec(text) ?? [];
  if (name && name.length <= LONGEST_NAME) return { kind: 'key', name: name.toLowerCase() };
  if (text === 'message') return { kind: 'message' };
  const address = readSocket(text);
  return address === undefined ? undefined : { kind: 'socket', address };
}

/** The address of a web socket of this machine; undefined for any other. */
function readSocket(text: string): string | undefined {
  const url = read(text);
  if (url?.protocol !== 'ws:' || !LOOPBACK.includes(url.hostname) || url.username || url.password) return undefined;
  // Web sockets take no hash.
  url.hash = '';
  return url.href;
}

function read(text: string): URL | undefined {
  try {
    return new URL(text);
  } catch {
    return undefined;
  }
}

/** Whether a message of another window starts the smoke. */
export function isTrigger(data: unknown): boolean {
  return (data as { cartoonSmoke?: unknown } | null | undefined)?.cartoonSmoke === 'trigger';
}

/** Whether a message of a web socket starts the smoke: the word, or the message of a window as JSON. */
export function isTriggerText(data: unknown): boolean {
  if (typeof data !== 'string') return false;
  if (data.trim() === 'trigger') return true;
  try {
    return isTrigger(JSON.parse(data));
  } catch {
    return false;
  }
}
