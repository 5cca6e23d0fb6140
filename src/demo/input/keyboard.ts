import { keyOf } from '../../internal.ts';

/** A direction in screen space, in steps. */
export type Direction = readonly [right: number, up: number, near: number];

/** Direction of each key. */
export const DIRECTIONS: Readonly<Record<string, Direction>> = {
  ArrowLeft: [-1, 0, 0],
  ArrowRight: [1, 0, 0],
  ArrowUp: [0, 1, 0],
  ArrowDown: [0, -1, 0],
  PageUp: [0, 0, -1],
  PageDown: [0, 0, 1],
};

/** Actions of the page's shortcut keys. */
export interface KeyActions {
  togglePlaying(): void;
  step(): void;
  stepBack(): void;
  /** Seeks by seconds, forwards or backwards. */
  shift(seconds: number): void;
  /** Stops a seek at the current time. */
  stopSeeking(): void;
  restart(): void;
  share(): void;
  capture(): void;
  help(): void;
  togglePanel(): void;
  search(): void;
  toggleGallery(): void;
  surprise(): void;
  toggleGizmos(): void;
  toggleTimeline(): void;
  toggleStatistics(): void;
  /** Drops an object into the smoke. */
  drop(): void;
  /** Blows into the smoke. */
  blow(): void;
  fullScreen(): void;
  nextView(): void;
  undo(): void;
  redo(): void;
  resetView(): void;
  zoom(factor: number): void;
  /** Orbits the camera in steps, to the right and up. */
  orbit(right: number, up: number): void;
  /** Direction in which the pressed keys push the movable rigid: right, up, towards the viewer, each -1, 0 or 1. */
  push(right: number, up: number, near: number): void;
}

const ZOOM_STEP = 1.15;

/** Keys whose action repeats while they are down. */
const REPEATING = new Set([',', '.', '[', ']', '+', '=', '-']);

/**
 * Listens to keys on the whole page, except those that a focused input needs.
 * @param hasShortcuts whether characters act. Speech input and screen readers send them by accident (WCAG 2.1.4)
 */
export function listenToKeys(actions: KeyActions, hasShortcuts: () => boolean): void {
  const simple = simpleKeys(actions);
  const held = new Set<string>();
  const push = () => {
    const [right, up, near] = [0, 1, 2].map((axis) => [...held].reduce((sum, key) => sum + DIRECTIONS[key][axis], 0));
    actions.push(Math.sign(right), Math.sign(up), Math.sign(near));
  };
  const release = (key: string) => {
    if (held.delete(key)) push();
  };
  addEventListener('keydown', (event) => {
    if (isUndo(event)) return undoOrRedo(event, actions);
    if (event.ctrlKey || event.metaKey || event.altKey || belongsToFocus(event)) return;
    const key = keyOf(event);
    const direction = DIRECTIONS[key];
    const action = simple[key];
    if (!direction && !action) return;
    if (/^\S$/u.test(key) && !hasShortcuts()) return;
    event.preventDefault();
    if (action) return event.repeat && !REPEATING.has(key) ? undefined : action();
    if (event.shiftKey) return actions.orbit(direction[0], direction[1]);
    held.add(key);
    push();
  });
  addEventListener('keyup', (event) => release(keyOf(event)));
  // A key that is released while another window has the focus fires no keyup event.
  addEventListener('blur', () => [...held].forEach(release));
}

function simpleKeys(actions: KeyActions): Readonly<Record<string, () => void>> {
  return {
    ' ': () => actions.togglePlaying(),
    '.': () => actions.step(),
    ',': () => actions.stepBack(),
    '[': () => actions.shift(-1),
    ']': () => actions.shift(1),
    Escape: () => actions.stopSeeking(),
    r: () => actions.restart(),
    s: () => actions.share(),
    c: () => actions.capture(),
    p: () => actions.togglePanel(),
    v: () => actions.nextView(),
    '/': () => actions.search(),
    g: () => actions.toggleGallery(),
    x: () => actions.surprise(),
    h: () => actions.toggleGizmos(),
    t: () => actions.toggleTimeline(),
    i: () => actions.toggleStatistics(),
    d: () => actions.drop(),
    b: () => actions.blow(),
    f: () => actions.fullScreen(),
    '?': () => actions.help(),
    '0': () => actions.resetView(),
    '+': () => actions.zoom(ZOOM_STEP),
    '=': () => actions.zoom(ZOOM_STEP),
    '-': () => actions.zoom(1 / ZOOM_STEP),
  };
}

function isUndo(event: KeyboardEvent): boolean {
  return (event.ctrlKey || event.metaKey) && !event.altKey && ['z', 'y'].includes(keyOf(event));
}

function undoOrRedo(event: KeyboardEvent, actions: KeyActions): void {
  event.preventDefault();
  if (event.shiftKey || keyOf(event) === 'y') actions.redo();
  else actions.undo();
}

/** Typing belongs to text fields, arrow keys to sliders and radio buttons, the space bar to buttons. */
function belongsToFocus(event: KeyboardEvent): boolean {
  const { target } = event;
  const key = keyOf(event);
  if (!(target instanceof Element)) return false;
  // The focus is not reliable: a button loses it when it is disabled.
  if (document.querySelector('dialog:modal')) return key !== '?';
  // A field in a dialog that has just closed keeps the focus until the next frame.
  if (target.getClientRects().length === 0) return false;
  if (target.matches('select, input:not([type=range], [type=checkbox], [type=color], [type=radio])')) return true;
  if (target.matches('input[type=range], input[type=radio]')) return key === ' ' || key in DIRECTIONS;
  return key === ' ' && target.matches('button, summary, input, a');
}
