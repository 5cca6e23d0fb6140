import type { Stage } from '../../index.ts';
import { create, iconButton, textButton } from './dom.ts';
import type { Flag } from './flag.ts';
import { icon } from './icons.ts';
import { strings } from '../strings.ts';

/** Text of the dialog. */
const text = {
  title: 'Play with smoke',
  docs: 'Documentation',
  paper: 'Comparison with the 2006 paper',
  puff: 'Smoke by one call: puff()',
  examples: 'Examples with their code',
  drivers: 'Smoke that follows scrolling, sound, MIDI knobs or the pointer',
  licenses: 'Third-party licences',
  hand: (thing: string) => `Drag ${thing}`,
  arrows: (thing: string) => ['\u2190 \u2192 \u2191 \u2193', `move ${thing}`] as const,
  depth: (thing: string) => ['Page Up, Page Down', `move ${thing} away or towards you`] as const,
  drops: [['Double click or double tap', 'drop a ball or a crate there']],
  dropKey: [['D', 'drop a ball or a crate where the pointer is']],
  pointer: [
    ['Drag elsewhere', 'turn the view'],
    ['Alt + drag elsewhere', 'blow into the smoke; with the wind button on, without Alt'],
    ['Wheel or pinch', 'zoom'],
    ['Right button or two fingers', 'pan the view'],
    ['Drag, or double click in the timeline', 'select or move keyframes, with Alt copy them; add one'],
    ['Ctrl + wheel or pinch in the timeline', 'zoom its axis'],
  ],
  keyboard: 'Keyboard',
  shortcuts: 'Shortcuts of a single character',
  keys: [
    ['Space', 'play or pause'],
    ['B', 'blow at the pointer, or in the middle'],
    [', and .', 'one step back, one step forward'],
    ['[ and ]', 'one second back, one second forward'],
    ['Esc', 'stop a long seek'],
    ['R', 'start over'],
    ['Shift + \u2190 \u2192 \u2191 \u2193', 'turn the view'],
    ['+ \u2212', 'zoom in, zoom out'],
    ['0', 'reset the view'],
    ['P', 'show or hide the parameters'],
    ['/', 'find a parameter'],
    ['G', 'show or hide the presets'],
    ['X', 'surprise me: a random scene in a random style'],
    ['H', 'show or hide the handles for light, wind, emitters and vortices'],
    ['Arrows on a handle', 'move it, with Shift in larger steps'],
    ['T', 'show or hide the timeline'],
    ['Arrows on a keyframe', 'move it by a frame, with Shift by a second; Up and Down go to other lanes'],
    ['Page Up, Page Down, Home, End on a keyframe', 'go to others of its lane; with Shift select them'],
    ['Enter, Delete, K on a keyframe', 'edit its value, remove it, set one at the playhead'],
    ['Ctrl + C, X, V, D, A in the timeline', 'copy, cut, paste, duplicate, select all'],
    ['F', 'enter or leave full screen'],
    ['I', 'show or hide statistics'],
    ['V', 'next debug view'],
    ['S', 'share this smoke'],
    ['C', 'capture a picture or a clip'],
    ['Ctrl + Z, Ctrl + Shift + Z', 'undo, redo'],
    ['?', 'show this help'],
  ],
} as const;

/** Dialog that lists all pointer gestures and keys of the current scene. */
export class Help {
  readonly element: HTMLDialogElement;
  private readonly stage: Stage;
  private readonly byHand = create('dl', {});
  private readonly byKeys = create('dl', {});

  /** @param noShortcuts whether shortcuts of a single character are turned off */
  constructor(stage: Stage, noShortcuts: Flag) {
    const { title, docs, keyboard, shortcuts, paper, puff, examples, drivers, licenses } = text;
    const { close } = strings.help;
    this.stage = stage;
    const button = textButton('loud', close, () => this.element.close());
    // On a phone the other close button is far below.
    const cross = iconButton('icon-button sheet-close', close, icon('close'), () => this.element.close());
    const links = create(
      'p',
      { class: 'help-links' },
      // The development server does not have it.
      ...(import.meta.env.PROD ? [create('a', { href: './docs/index.html' }, docs)] : []),
      create('a', { href: './paper.html' }, paper),
      create('a', { href: './puff.html' }, puff),
      create('a', { href: './examples.html' }, examples),
      create('a', { href: './examples.html#scroll' }, drivers),
      create('a', { href: './third-party-licenses.txt' }, licenses),
    );
    // Otherwise the first link, far below, would get the initial focus.
    const heading = create('h2', { id: 'help-title', tabindex: -1, autofocus: true }, title);
    const attributes = { class: 'sheet card help', 'aria-labelledby': 'help-title' };
    const middle = create('h3', {}, keyboard);
    const box = create('input', { type: 'checkbox', checked: !noShortcuts.value });
    box.addEventListener('change', () => (noShortcuts.value = !box.checked));
    const choice = create('label', { class: 'help-shortcuts' }, box, shortcuts);
    this.element = create(
      'dialog',
      attributes,
      heading,
      cross,
      this.byHand,
      middle,
      choice,
      this.byKeys,
      links,
      button,
    );
  }

  /** Opens or closes the dialog. */
  toggle(): void {
    if (this.element.open) return this.element.close();
    const { hand, keys } = rows(this.stage);
    this.byHand.replaceChildren(...hand.flatMap(describe));
    this.byKeys.replaceChildren(...keys.flatMap(describe));
    this.element.showModal();
  }
}

type Row = readonly [what: string, does: string];

function rows(stage: Stage): { hand: readonly Row[]; keys: readonly Row[] } {
  const { hand, arrows, depth, drops, dropKey, pointer, keys } = text;
  const held = strings.scenes[String(stage.get().scene)]?.hand;
  const drag: Row[] = held ? [[hand(held.thing), held.does]] : [];
  const move: Row[] = held ? [arrows(held.thing), depth(held.thing)] : [];
  const canDrop = stage.dropCount > 0;
  return {
    hand: [...drag, ...pointer, ...(canDrop ? drops : [])],
    keys: [...move, ...(canDrop ? dropKey : []), ...keys],
  };
}

function describe([what, does]: Row): HTMLElement[] {
  return [create('dt', {}, what), create('dd', {}, does)];
}
