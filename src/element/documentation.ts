/**
 * What editors and the README say of the element besides its parameters. It goes into the custom-elements manifest and
 * into no bundle.
 */

const flag = { text: 'boolean' };
const string = { text: 'string' };

export const attributes = [
  { name: 'preset', type: string, default: 'lamp', description: 'Name of a preset, such as `wisp`.' },
  {
    name: 'src',
    type: string,
    description:
      'A share link of the demo page; its `t` and `paused` count, too. Another one that leads to a moment, by `t`, `start` or what somebody did, begins anew there; one that does not changes smoke of the same scene as it goes on.',
  },
  { name: 'paused', type: flag, description: 'Does not play. The button in the corner sets and removes it.' },
  { name: 'transparent', type: flag, description: 'Shows the page behind the smoke in the place of a backdrop.' },
  {
    name: 'interactive',
    type: flag,
    description:
      'Takes pointers and keys - arrows turn, + and - zoom, 0 goes back - and leaves the wheel and swipes up and down to the page. Without it all go to what lies below.',
  },
  { name: 'start', type: { text: 'number' }, description: 'Simulated seconds before the first picture, 0 to 600.' },
  { name: 'alt', type: string, description: 'What screen readers say; empty where the smoke is ornament.' },
  {
    name: 'label-play',
    type: string,
    default: 'Play smoke',
    description: 'What the button says to screen readers while it would play.',
  },
  {
    name: 'label-pause',
    type: string,
    default: 'Pause smoke',
    description: 'What it says while it would pause.',
  },
  {
    name: 'collide',
    type: string,
    description:
      'A CSS selector: smoke flows around the boxes of the elements that it fits, wherever they go. Eight at once: of more, those in the picture and nearest to where smoke rises, found anew whenever they move; `statechange` tells so. It curls at the ends of the nearest four.',
  },
  {
    name: 'emit-from',
    type: string,
    description:
      'A CSS selector: smoke rises from the first eight elements that it fits. The preset `air` has nothing else.',
  },
  {
    name: 'emit-on',
    type: { text: "'always' | 'hover' | 'click'" },
    default: 'always',
    description:
      'When smoke rises from them; `hover` is under the pointer or the keyboard, and for a moment after a tap.',
  },
  {
    name: 'loading',
    type: { text: "'lazy' | 'eager'" },
    default: 'lazy',
    description: 'Whether to fetch the smoke when the element nears the viewport or at once.',
  },
  {
    name: 'thread',
    type: { text: "'auto' | 'main' | 'worker'" },
    default: 'auto',
    description: 'Where the smoke is computed and drawn: in a worker where the browser can, by default.',
  },
];

export const events = [
  { name: 'ready', type: { text: "SmokeEvent<'ready'>" }, description: 'The first picture stands.' },
  {
    name: 'error',
    type: { text: "SmokeEvent<'error'>" },
    description: 'There is no smoke, or no more; `detail.error` says why. The poster and the fallback are shown.',
  },
  {
    name: 'statechange',
    type: { text: "SmokeEvent<'statechange'>" },
    description:
      'Playing began or ended (`detail.playing`), or attributes were not taken as they stood (`detail.notices`).',
  },
];

export const methods = [
  { name: 'play', description: 'Plays, as the button does.' },
  { name: 'pause', description: 'Pauses, as the button does.' },
  { name: 'seek', description: 'Goes to a simulated time, in seconds.' },
  { name: 'step', description: 'Takes whole steps of 1/60 s.' },
  {
    name: 'set',
    description:
      'Changes parameters by flat key, such as `{ "emission.rate": 60 }`; refuses what is out of range with a ParameterError.',
  },
  { name: 'get', description: 'All values by flat key.' },
  { name: 'picture', description: 'The present picture as a PNG.' },
  { name: 'stats', description: 'What the smoke is doing.' },
];

export const slots = [
  {
    name: 'poster',
    description:
      'A picture that stands until the smoke does, and when there is none, as large as the element. The image of a `<picture>` is as wide, unless the page or its attributes size it.',
  },
  { name: '', description: 'What is shown where there can be no smoke, and by browsers without JavaScript.' },
];

export const cssParts = [
  { name: 'frame', description: 'The box of everything.' },
  {
    name: 'canvas',
    description: 'What the smoke is drawn on. With `touch-action: none` an interactive one has all swipes.',
  },
  { name: 'poster', description: 'The box of the poster.' },
  { name: 'fallback', description: 'The box of the fallback.' },
  { name: 'button', description: 'The button that pauses and plays.' },
];

export const cssProperties = [
  { name: '--cartoon-smoke-button-size', default: '36px', description: 'Width and height of the button.' },
  { name: '--cartoon-smoke-button-inset', default: '10px', description: 'How far it stands from the corner.' },
  { name: '--cartoon-smoke-button-color', default: '#1d1720', description: 'Its ink.' },
  { name: '--cartoon-smoke-button-background', default: '#fff8ecd9', description: 'Its paper.' },
  { name: '--cartoon-smoke-focus-color', default: '#2f6fde', description: 'The ring around it under the keyboard.' },
];
