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
import { ParameterError } from '../../base/errors.ts';
import type { StageEvents } from '../contract.ts';
import type { Take } from '../take.ts';
import type { MethodName } from './calls.ts';
import { methodNames, methods, type MethodEntry } from './methods.ts';
import { packError, unpackError, type PackedError } from './packedErrors.ts';
import { figures, flag, integer, isPlain, nothing, oneOf, record, type Shape } from './shapes.ts';

/** The id of the stage's first message, which answers no request. */
export const OPENING = 0;

export type EventName = keyof StageEvents;

type Exchange = Pick<MethodEntry, 'takes' | 'gives'>;

const ofEvent = { takes: [oneOf('statechange', 'error', 'frame')], gives: nothing };
const exchanges = { ...methods, listen: ofEvent, unlisten: ofEvent, dispose: { takes: [], gives: nothing } };

/** A method of a stage, or another request. */
export type Method = MethodName | 'listen' | 'unlisten' | 'dispose';

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
  if (!isMethod(method)) return { id, error: new ParameterError('method', describe(method), methodNames.join(', ')) };
  if (!Array.isArray(args) || args.length > MAX_ARGUMENTS)
    return { id, error: new ParameterError('args', describe(args), `an array of at most ${MAX_ARGUMENTS}`) };
  const { takes }: Exchange = exchanges[method];
  const wrong = takes.findIndex((isRight, place) => !isRight(args[place]));
  if (wrong < 0) return { id, method, args: args.slice(0, takes.length) as unknown[] };
  const error = demandedBy(takes[wrong], args[wrong]);
  const name = `argument ${wrong + 1} of ${method}`;
  return { id, error: error ?? new ParameterError(name, describe(args[wrong]), takes[wrong].words) };
}

function isMethod(name: unknown): name is Method {
  return typeof name === 'string' && Object.hasOwn(exchanges, name);
}

/** The error that the stage itself throws for an argument; undefined if the stage accepts it. */
function demandedBy({ demand }: Shape, argument: unknown): Error | undefined {
  try {
    demand?.(typeof argument === 'number' ? argument : describe(argument));
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
  const { gives }: Exchange = exchanges[method];
  return gives(value) ? { id, value: gives.unpack ? gives.unpack(value) : value } : undefined;
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

/** Converts an argument to a cloneable value: a take becomes its bytes, and a Proxy of values or keys a copy. */
export function packArgument(argument: unknown): unknown {
  const { toBytes } = (argument ?? {}) as Partial<Take>;
  if (typeof toBytes === 'function') return toBytes();
  if (Array.isArray(argument)) return [...argument];
  return Object.prototype.toString.call(argument) === '[object Object]' ? { ...(argument as object) } : argument;
}

/** Converts a result to a cloneable value, with the objects to transfer instead of copying. */
export function packValue(method: Method, result: unknown): { value: unknown; moved: Transferable[] } {
  const { gives }: Exchange = exchanges[method];
  const value = gives.pack ? gives.pack(result) : result;
  return { value, moved: gives.transferred?.(value) ?? [] };
}

/**
 * The handshake between a page and the stage in an iframe, before they share a MessagePort.
 * 'here': the iframe announces itself. 'connect': the page requests the stage and transfers a port.
 */
export type HandshakeStep = 'here' | 'connect';

export function handshake(step: HandshakeStep): { cartoonSmoke: HandshakeStep } {
  return { cartoonSmoke: step };
}

export function isHandshake(message: unknown, step: HandshakeStep): boolean {
  return isPlain(message) && message.cartoonSmoke === step && Object.keys(message).length === 1;
}
