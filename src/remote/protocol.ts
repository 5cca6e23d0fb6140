/**
 * The messages between a stage and whoever has it from elsewhere, the same for workers and frames. They go through a
 * MessagePort that belongs to one stage:
 *
 *     { id: 7, method: 'set', args: [{ 'emission.rate': 240 }] }       to the stage
 *     { id: 7, value: undefined }  or  { id: 7, error: { name, message } }   from it
 *     { event: 'statechange', detail: { playing: true } }               from it, while asked for by `listen`
 *
 * The stage's first message is a reply to the id 0: it is there, or why it is not. An error for the id 0 after that says that it is
 * gone. Whatever else comes is not heeded.
 */
import { ParameterError } from '../preset/errors.ts';
import type { StageEvents } from '../stage/contract.ts';
import type { Take } from '../stage/take.ts';
import { calls } from './calls.ts';
import type { RemoteMethods } from './contract.ts';
import { packError, unpackError, type PackedError } from './packedErrors.ts';
import { figures, flag, integer, isPlain, oneOf, record, type Check } from './shapes.ts';

/** The id of the reply that nobody asks for. */
export const OPENING = 0;

export type EventName = keyof StageEvents;

/** What is asked beside the methods of a stage. */
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

/** A request that was understood, or one whose sender can be told why it was not. */
export type ReadRequest = Request | { readonly id: number; readonly error: Error };

const isId = integer(1, 2 ** 53 - 1);
const MAX_ARGUMENTS = 8;

/** @returns undefined for what is no request at all */
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

/** The error with which the stage itself refuses the first argument; undefined where it would take it. */
function demandedBy(method: keyof RemoteMethods, first: unknown): Error | undefined {
  try {
    calls[method]?.demand?.(typeof first === 'number' ? first : describe(first));
    return undefined;
  } catch (error) {
    return error as Error;
  }
}

/** Short, and without asking an untrusted object to describe itself. */
function describe(value: unknown): unknown {
  if (typeof value === 'string') return value.slice(0, 40);
  if (Array.isArray(value)) return 'an array';
  return typeof value === 'object' && value !== null ? 'an object' : value;
}

/**
 * @param methodOf what was asked with an id; undefined for ids that nobody waits for
 * @returns the id with what was given or thrown; undefined for what is no reply to anything
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

/** @returns undefined for what tells of nothing */
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

/** Methods that give a take, which has a function and crosses as its bytes. */
const TAKES: ReadonlySet<Method> = new Set(['take', 'readTake']);

/** An argument as it can be sent: a take as its bytes. */
export function packArgument(argument: unknown): unknown {
  const { toBytes } = (argument ?? {}) as Partial<Take>;
  return typeof toBytes === 'function' ? toBytes() : argument;
}

/** A value as it can be sent, and what of it moves instead of being copied. */
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
