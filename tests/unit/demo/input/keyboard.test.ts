/** Shortcut keys on layouts without and with Latin letters. */
import { Window } from 'happy-dom';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { listenToKeys, type KeyActions } from '../../../../src/demo/input/keyboard.ts';

type Press = [layout: string, key: string, code: string, action: keyof KeyActions | '', modifiers?: KeyboardEventInit];

const ctrlKey = true;
const shiftKey = true;

const PRESSES: readonly Press[] = [
  ['US', 'r', 'KeyR', 'restart'],
  ['US, caps lock', 'R', 'KeyR', 'restart'],
  ['Russian', 'к', 'KeyR', 'restart'],
  ['Russian, caps lock', 'К', 'KeyR', 'restart'],
  ['Russian', 'х', 'BracketLeft', 'shift'],
  ['Russian', 'ю', 'Period', 'step'],
  ['Russian', '.', 'Slash', 'step'],
  ['Russian', '?', 'Digit7', 'help', { shiftKey }],
  ['Russian', 'я', 'KeyZ', 'undo', { ctrlKey }],
  ['Russian', 'Я', 'KeyZ', 'redo', { ctrlKey, shiftKey }],
  ['Russian, Mac', 'н', 'KeyY', 'redo', { metaKey: true }],
  ['Ukrainian', 'і', 'KeyS', 'share'],
  ['Ukrainian', 'ї', 'BracketRight', 'shift'],
  ['Greek', 'ρ', 'KeyR', 'restart'],
  ['Greek', 'ζ', 'KeyZ', 'undo', { ctrlKey }],
  ['Greek', ';', 'KeyQ', ''],
  ['Bulgarian', 'и', 'KeyR', 'restart'],
  ['Bulgarian', ',', 'KeyQ', 'stepBack'],
  ['Hebrew', 'ר', 'KeyR', 'restart'],
  ['Hebrew', '/', 'KeyQ', 'search'],
  ['Hebrew', 'ז', 'KeyZ', 'undo', { ctrlKey }],
  ['Arabic', 'ق', 'KeyR', 'restart'],
  ['Arabic, two characters', 'لا', 'KeyB', 'blow'],
  ['Arabic', '؟', 'Slash', 'help', { shiftKey }],
  ['Arabic', '٠', 'Digit0', 'resetView'],
  ['Persian', '+', 'Equal', 'zoom', { shiftKey }],
  ['AZERTY', 'a', 'KeyQ', ''],
  ['AZERTY', 'z', 'KeyW', 'undo', { ctrlKey }],
  ['AZERTY', 'w', 'KeyZ', '', { ctrlKey }],
  ['AZERTY', ',', 'KeyM', 'stepBack'],
  ['AZERTY', 'à', 'Digit0', ''],
  ['QWERTZ', 'z', 'KeyY', 'undo', { ctrlKey }],
  ['QWERTZ', 'y', 'KeyZ', 'redo', { ctrlKey }],
  ['QWERTZ', 'ü', 'BracketLeft', ''],
  ['QWERTZ', 'Dead', 'Equal', ''],
  ['Dvorak', 'r', 'KeyO', 'restart'],
  ['Dvorak', 'p', 'KeyR', 'togglePanel'],
  ['Dvorak', ';', 'KeyZ', '', { ctrlKey }],
  ['Japanese input', 'Process', 'KeyR', ''],
  ['touch keyboard', 'Unidentified', '', ''],
  ['Russian, AltGr', 'к', 'KeyR', '', { ctrlKey, altKey: true }],
];

let window: Window;
let called: string[];

beforeEach(() => {
  window = new Window();
  vi.stubGlobal('Element', window.Element);
  vi.stubGlobal('document', window.document);
  vi.stubGlobal('addEventListener', window.addEventListener.bind(window));
  called = [];
  const actions = new Proxy({} as KeyActions, { get: (_, name: string) => () => called.push(name) });
  listenToKeys(actions, () => true);
});

afterEach(() => vi.unstubAllGlobals());

test.each(PRESSES)('%s: %s at %s does %s', (_, key, code, action, modifiers = {}) => {
  window.dispatchEvent(new window.KeyboardEvent('keydown', { key, code, ...modifiers } as object));
  expect(called).toEqual(action ? [action] : []);
});
