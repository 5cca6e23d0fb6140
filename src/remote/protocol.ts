/**
 * The message protocol between a stage and its client, for workers and iframes. Each stage has its own MessagePort:
 *
 *     { id: 7, method: 'set', args: [{ 'emission.rate': 240 }] }       to the stage
 *     { id: 7, value: undefined }  or  { id: 7, error: { name, message } }   from it
 *     { event: 'statechange', detail: { playing: true } }               from it, while subscribed by `listen`
 *
 * The stage's first message is a reply with id 0: the stage is open, or an error. A later error with id 0 means that
 * the stage is gone. All other messages are ignored.
 */
import { ParameterError } from '../preset/errors.ts';
import type { StageEvents } from '../stage/contract.ts';
import type { Take } from '../stage/take.ts';
import { calls } from './calls.ts';
import type { RemoteMethods } from './contract.ts';
import { packError, unpackError, type PackedError } from './packedErrors.ts';
import { figures, flag, integer, isPlain, oneOf, record, type Check } from './shapes.ts';

/** The id of the stage's first message, which answers no request. */
export const OPENING = 0;

export type EventName = keyof StageEvents;

/** Requests other than the methods of a stage. */
const talk: Readonly<Record<string, readonly Check[]>> = {
  listen: [oneOf('statechange', 'error', 'frame')],
  unlisten: [oneOf('statechange', 'error', 'frame')],
  dispose: [],
};

export type Method = keyof RemoteMethods | 'listen' | 'unlisten' | 'dispose';

export interface Request {
  readonly id: number;
  readonly method: Method;
  readonly args: readonly unknown[];
}

export type Reply = { readonly id: number; readonly value?: unknown; readonly error?: PackedError };

export interface Notification {
  readonly event: EventName | 'progress';
  readonly detail: unknown;
}

/** A valid request, or the error to reply with. */
export type ReadRequest = Request | { readonly id: number; readonly error: Error };

const isId = integer(1, 2 ** 53 - 1);
const MAX_ARGUMENTS = 8;

/** @returns undefined if the message is not a request */
export function readRequest(message: unknown): ReadRequest | undefined {
  if (!isPlain(message) || !isId(message.id)) return undefined;
  const { id, method, args = [] } = message as { id: number; method: unknown; args: unknown };
  const takes = takenBy(method);
  if (!takes) return { id, error: new ParameterError('method', describe(method), Object.keys(calls).join(', ')) };
  if (!Array.isArray(args) || args.length > MAX_ARGUMENTS)
    return { id, error: new ParameterError('args', describe(args), `an array of at most ${MAX_ARGUMENTS}`) };
  const wrong = takes.findIndex((check, place) => !check(args[place]));
  if (wrong >= 0) {
    const error = demandedBy(method as keyof RemoteMethods, args[0]);
    if (error) return { id, error };
    const name = `argument ${wrong + 1} of ${String(method)}`;
    return { id, error: new ParameterError(name, describe(args[wrong]), takes[wrong].words) };
  }
  return { id, method: method as Method, args: args.slice(0, takes.length) as unknown[] };
}

function takenBy(method: unknown): readonly Check[] | undefined {
  if (typeof method !== 'string') return undefined;
  if (Object.hasOwn(calls, method)) return calls[method as keyof RemoteMethods].takes;
  return Object.hasOwn(talk, method) ? talk[method] : undefined;
}

/** The error that the stage itself throws for the first argument; undefined if the stage accepts it. */
function demandedBy(method: keyof RemoteMethods, first: unknown): Error | undefined {
  try {
    calls[method]?.demand?.(typeof first === 'number' ? first : describe(first));
    return undefined;
  } catch (error) {
    return error as Error;
  }
}

/** Short, and never calls toString on an untrusted object. */
function describe(value: unknown): unknown {
  if (typeof value === 'string') return value.slice(0, 40);
  if (Array.isArray(value)) return 'an array';
  return typeof value === 'object' && value !== null ? 'an object' : value;
}

/**
 * @param methodOf the pending method of an id; undefined for unknown ids
 * @returns the id with the result or the error; undefined if the message is not a valid reply
 */
export function readReply(
  message: unknown,
  methodOf: (id: number) => Method | undefined,
): { id: number; value: unknown } | { id: number; thrown: Error } | undefined {
  if (!isPlain(message) || typeof message.id !== 'number') return undefined;
  const { id, value, error } = message;
  const method = methodOf(id);
  if (!method) return undefined;
  const thrown = unpackError(error);
  if (thrown) return { id, thrown };
  const isRight = Object.hasOwn(calls, method)
    ? calls[method as keyof RemoteMethods].gives(value)
    : value === undefined;
  return isRight ? { id, value: unpackValue(method, value) } : undefined;
}

const details: Readonly<Record<Notification['event'], (detail: unknown) => boolean>> = {
  statechange: record({ playing: flag }),
  frame: figures,
  error: (detail) => unpackError(detail) !== undefined,
  progress: (detail) => isPlain(detail) && typeof detail.loaded === 'number',
};

/** @returns undefined if the message is not a notification */
export function readNotification(message: unknown): Notification | undefined {
  if (!isPlain(message) || typeof message.event !== 'string' || !Object.hasOwn(details, message.event))
    return undefined;
  const event = message.event as Notification['event'];
  if (!details[event](message.detail)) return undefined;
  return { event, detail: event === 'error' ? unpackError(message.detail) : message.detail };
}

export function notificationOf(event: Notification['event'], detail: unknown): Notification {
  return { event, detail: event === 'error' ? packError(detail) : detail };
}

/** Methods that return a take. A take contains a function, so it is sent as its bytes. */
const TAKES: ReadonlySet<Method> = new Set(['take', 'readTake']);

/** Converts an argument to a cloneable value: a take becomes its bytes, and a Proxy of values or keys a copy. */
export function packArgument(argument: unknown): unknown {
  const { toBytes } = (argument ?? {}) as Partial<Take>;
  if (typeof toBytes === 'function') return toBytes();
  if (Array.isArray(argument)) return [...argument];
  return Object.prototype.toString.call(argument) === '[object Object]' ? { ...(argument as object) } : argument;
}

/** Converts a result to a cloneable value, with the objects to transfer instead of copying. */
export function packValue(method: Method, value: unknown): { value: unknown; moved: Transferable[] } {
  if (TAKES.has(method)) {
    const take = value as Take;
    const bytes = take.toBytes();
    return { value: { ...take, toBytes: undefined, bytes }, moved: [bytes.buffer] };
  }
  if (value instanceof Uint8Array && value.byteLength === value.buffer.byteLength) {
    return { value, moved: [value.buffer as ArrayBuffer] };
  }
  return { value, moved: [] };
}

function unpackValue(method: Method, value: unknown): unknown {
  if (!TAKES.has(method)) return value;
  const { bytes, ...rest } = value as Omit<Take, 'toBytes'> & { bytes: Uint8Array<ArrayBuffer> };
  return { ...rest, toBytes: () => bytes.slice() } satisfies Take;
}
