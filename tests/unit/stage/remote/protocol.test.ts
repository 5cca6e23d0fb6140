/** The messages between a stage and its remote client: valid ones are read, all others rejected. */
import { expect, test } from 'vitest';
import {
  ContextError,
  LoadError,
  ParameterError,
  ShapeError,
  SimulatorError,
  SmokeError,
  UnsupportedError,
} from '../../../../src/base/errors.ts';
import { methodNames } from '../../../../src/stage/remote/methods.ts';
import { packError, unpackError } from '../../../../src/stage/remote/packedErrors.ts';
import { PortStage } from '../../../../src/stage/remote/portStage.ts';
import {
  packArgument,
  packValue,
  readReply,
  readRequest,
  readNotification,
  notificationOf,
} from '../../../../src/stage/remote/protocol.ts';
import { hostileMessages } from '../../../support/hostileMessages.ts';
import { EXAMPLE_TAKE } from '../../../support/exampleTake.ts';

test.each([
  [{ id: 1, method: 'play', args: [] }],
  [{ id: 1, method: 'play' }],
  [{ id: 2, method: 'set', args: [{ 'emission.rate': 3, 'vortices.0.circulation': 2 }] }],
  [{ id: 3, method: 'step', args: [] }],
  [{ id: 4, method: 'pointer', args: [{ type: 'down', id: 1, x: 3, y: 4 }] }],
  [{ id: 5, method: 'listen', args: ['frame'] }],
])('%o is accepted', (message) => {
  expect(readRequest(structuredClone(message))).toMatchObject({ id: message.id, method: message.method });
});

test.each([
  ['a method that is none', { method: 'constructor', args: [] }],
  ['a getter', { method: 'ready', args: [] }],
  ['an argument too few', { method: 'seek', args: [] }],
  ['a number that is none', { method: 'seek', args: [Number.NaN] }],
  ['more steps than ten minutes', { method: 'step', args: [36_001] }],
  ['a key of a prototype', { method: 'set', args: [JSON.parse('{"__proto__":1}')] }],
  ['a value that is an object', { method: 'set', args: [{ seed: {} }] }],
  ['a timeline without end', { method: 'set', args: [{ timeline: 'x'.repeat(20_000) }] }],
  ['a timeline that is a number', { method: 'enter', args: [{ timeline: 60 }] }],
  ['a timeline that is a list', { method: 'set', args: [{ timeline: [] }] }],
  ['a text without end', { method: 'set', args: [{ seed: 'x'.repeat(10_000) }] }],
  ['a list that is none', { method: 'set', args: { 0: {}, length: 1 } }],
  ['an event that there is not', { method: 'listen', args: ['progress'] }],
  ['a pointer with more to it', { method: 'pointer', args: [{ type: 'up', id: 1, x: 0, y: 0, z: 0 }] }],
])('%s is rejected with an error for the caller', (_, message) => {
  const read = readRequest({ id: 1, ...message });
  expect(read).toMatchObject({ id: 1, error: { name: 'ParameterError' } });
});

test.each([
  ['seek', [601], 'argument 1 of seek cannot be 601: it takes a number from 0 to 600.'],
  ['step', [1.5], 'n cannot be 1.5: it takes a whole number from 0 to 4294967295.'],
  ['step', [36_001], 'argument 1 of step cannot be 36001: it takes a whole number from 0 to 36000.'],
  ['seek', [], 'seconds cannot be undefined: it takes a number from 0.'],
  ['seek', [-1], 'seconds cannot be -1: it takes a number from 0.'],
  ['advance', ['1'], 'seconds cannot be “1”: it takes a number from 0.'],
  ['advance', [[]], 'seconds cannot be “an array”: it takes a number from 0.'],
  ['zoom', [0], 'argument 1 of zoom cannot be 0: it takes a number from 0.000001 to 1000000.'],
  ['resize', [3, -1], 'argument 2 of resize cannot be -1: it takes a number from 0 to 65536.'],
  ['unset', ['a'], 'argument 1 of unset cannot be “a”: it takes an array of at most 4000, each a key.'],
  ['blow', [{}], 'argument 1 of blow cannot be “an object”: it takes an object of x, y, dx, dy, radius, seconds.'],
])('%s(%o) is rejected with a message', (method, args, words) => {
  const { error } = readRequest({ id: 1, method, args }) as { error: Error };
  expect(error.message).toBe(words);
  expect(unpackError(structuredClone(packError(error)))?.message).toBe(words);
});

test('five thousand hostile messages are all rejected, and none is read as a reply or an event', () => {
  let count = 0;
  for (const message of hostileMessages(5_000, 5)) {
    const read = readRequest(message);
    // The stage rejects well-formed messages with invalid values itself.
    if (read && 'method' in read)
      expect(['set', 'enter', 'restore', 'emit', 'changeEmission', 'setModel', 'playTake', 'readTake']).toContain(
        read.method,
      );
    expect(readReply(message, () => 'hash')).toBeUndefined();
    expect(readNotification(message)).toBeUndefined();
    count += 1;
  }
  expect(count).toBe(5_000);
});

test.each([
  new ParameterError('emission.rate', -5, '0 to 1,000'),
  new LoadError('gone'),
  new UnsupportedError('too old'),
  new SimulatorError('dead'),
  new ContextError('lost'),
  new ShapeError('open'),
])('%s keeps its class and message across the port', (error) => {
  const other = unpackError(structuredClone(packError(error)));
  expect(other).toBeInstanceOf(error.constructor);
  expect(other).toBeInstanceOf(SmokeError);
  expect(other).toEqual(error);
  expect(other?.message).toBe(error.message);
});

test('an error of an unknown class keeps only its name and its message', () => {
  const error = Object.assign(new RangeError('too far'), { secret: 1 });
  expect(unpackError(structuredClone(packError(error)))).toMatchObject({ name: 'RangeError', message: 'too far' });
  expect(packError(error)).not.toHaveProperty('secret');
  expect(unpackError({ name: '__proto__', message: 'x' })?.name).toBe('__proto__');
});

test('a take crosses as its bytes', () => {
  const { value, moved } = packValue('take', EXAMPLE_TAKE);
  const reply = readReply(structuredClone({ id: 9, value }, { transfer: moved }), () => 'take');
  expect(reply).toMatchObject({ id: 9, value: { seed: 3, steps: 60, values: { scene: 'wisp' } } });
  expect((reply as { value: typeof EXAMPLE_TAKE }).value.toBytes()).toEqual(Uint8Array.of(1, 2, 3));
});

test('a take is sent as its bytes', () => {
  expect(packArgument(EXAMPLE_TAKE)).toEqual(Uint8Array.of(1, 2, 3));
  for (const argument of [Uint8Array.of(4), 'toBytes', { toBytes: 1 }, 0, null, undefined])
    expect(packArgument(argument)).toEqual(argument);
});

test('options that need the same thread are not sent', async () => {
  const { port1, port2 } = new MessageChannel();
  const { stage: face, opened } = new PortStage(port1, 'worker');
  const came = new Promise<unknown>((resolve) => (port2.onmessage = ({ data }) => resolve(data)));
  const seek = face.seek as (...args: unknown[]) => Promise<void>;
  const asked = seek(2, { onProgress: () => undefined });
  expect(await Promise.race([came, asked])).toEqual({ id: 1, method: 'seek', args: [2] });
  await face.dispose();
  await expect(asked).rejects.toBeInstanceOf(SimulatorError);
  await expect(opened).rejects.toBeInstanceOf(SimulatorError);
});

test('a reply of the wrong shape is rejected', () => {
  for (const name of methodNames) {
    const strange = { id: 1, value: { length: 1, x: {} } };
    expect(
      readReply(strange, () => name),
      name,
    ).toBeUndefined();
  }
  expect(readReply({ id: 1, value: 'abc' }, () => undefined)).toBeUndefined();
});

test('events are sent and read', () => {
  expect(readNotification(notificationOf('statechange', { playing: true }))).toEqual({
    event: 'statechange',
    detail: { playing: true },
  });
  expect(readNotification(notificationOf('error', new ContextError('lost')))?.detail).toBeInstanceOf(ContextError);
  expect(readNotification({ event: 'statechange', detail: { playing: 'yes' } })).toBeUndefined();
  expect(readNotification({ event: 'toString', detail: {} })).toBeUndefined();
});
