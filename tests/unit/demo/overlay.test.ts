/** The query of `overlay.html`, and the messages that start its smoke. */
import { expect, test } from 'vitest';
import { isTrigger, isTriggerText, readOptions } from '../../../src/demo/overlay/options.ts';

const query = (...triggers: string[]) => triggers.map((trigger) => `trigger=${encodeURIComponent(trigger)}`).join('&');

test.each([
  ['key:F9', { kind: 'key', name: 'f9' }],
  ['key:s', { kind: 'key', name: 's' }],
  ['key:Numpad1', { kind: 'key', name: 'numpad1' }],
  ['message', { kind: 'message' }],
  ['ws://127.0.0.1:4455', { kind: 'socket', address: 'ws://127.0.0.1:4455/' }],
  ['ws://localhost:8080/smoke?room=1#part', { kind: 'socket', address: 'ws://localhost:8080/smoke?room=1' }],
  ['WS://LOCALHOST', { kind: 'socket', address: 'ws://localhost/' }],
  // Another notation of the same address.
  ['ws://2130706433:80', { kind: 'socket', address: 'ws://127.0.0.1/' }],
])('accepts %s', (text, trigger) => {
  expect(readOptions(`?${query(text)}`)).toMatchObject({ triggers: [trigger], waits: true, notices: [] });
});

test.each([
  '',
  'key:',
  'key:two words',
  'key:a-name-that-no-key-has',
  'keys:F9',
  'Message',
  'messages',
  'ws:',
  'ws://',
  'ws://example.org',
  'ws://192.168.0.2:4455',
  'ws://127.0.0.2:4455',
  'ws://0.0.0.0:4455',
  'ws://127.0.0.1.example.org',
  'ws://localhost.example.org',
  'ws://localhost.',
  'ws://127.0.0.1@example.org',
  'ws://example.org#127.0.0.1',
  'ws://example.org/?host=127.0.0.1',
  'ws://user:secret@127.0.0.1:4455',
  'ws://[::1]:4455',
  'ws://127.0.0.1:99999',
  'wss://127.0.0.1:4455',
  'http://127.0.0.1:4455',
  'javascript:127.0.0.1',
])('refuses the trigger “%s”, and waits all the same', (text) => {
  const { triggers, waits, notices } = readOptions(`?${query(text)}`);
  expect({ triggers, waits }).toEqual({ triggers: [], waits: true });
  expect(notices.map(({ code, key, given }) => ({ code, key, given: given.slice(0, 20) }))).toEqual([
    { code: 'malformed', key: 'trigger', given: text.slice(0, 20) },
  ]);
});

test.each([
  ['', { waits: false, seconds: Number.POSITIVE_INFINITY, explains: false }],
  ['?seconds=8', { waits: false, seconds: 8 }],
  ['?trigger=message', { waits: true, seconds: 5 }],
  ['?trigger=message&seconds=0.5&ui=1', { waits: true, seconds: 0.5, explains: true }],
  ['?trigger=message&ui', { explains: false }],
])('reads %s', (search, expected) => {
  expect(readOptions(search)).toMatchObject({ ...expected, notices: [] });
});

test('keeps the valid ones of several triggers, and reports seconds out of range', () => {
  const { triggers, seconds, notices } = readOptions(`?${query('key:a', 'ws://example.org', 'message')}&seconds=99999`);
  expect(triggers.map(({ kind }) => kind)).toEqual(['key', 'message']);
  expect(seconds).toBe(600);
  expect(notices.map(({ key }) => key)).toEqual(['trigger', 'seconds']);
});

const TRIGGER = { cartoonSmoke: 'trigger' };

test.each([
  ['a word', 'trigger', true],
  ['a line', 'trigger\n', true],
  ['an object', JSON.stringify({ ...TRIGGER, id: 3 }), true],
  ['nothing', '', false],
  ['another word', 'triggers', false],
  ['JSON of a word', '"trigger"', false],
  ['null', 'null', false],
  ['another object', '{"cartoonSmoke":"connect"}', false],
  ['a list', '[{"cartoonSmoke":"trigger"}]', false],
  ['damaged JSON', '{"cartoonSmoke":"trigger"', false],
  ['bytes', new ArrayBuffer(8), false],
])('a web socket with %s', (_, data, isOne) => {
  expect(isTriggerText(data)).toBe(isOne);
});

test.each([
  [TRIGGER, true],
  ['trigger', false],
  [null, false],
  [undefined, false],
  [7, false],
  [{ cartoonSmoke: { trigger: 1 } }, false],
])('a message %j of another window', (data, isOne) => {
  expect(isTrigger(data)).toBe(isOne);
});
