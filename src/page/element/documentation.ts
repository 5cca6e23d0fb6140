/**
 * Descriptions of the element's API except the parameters, for docs/element.md and the custom-elements manifest. No
 * bundle contains them.
 */

const flag = { text: 'boolean' };
const string = { text: 'string' };

export const attributes = [
  {
    name: 'preset',
    type: string,
    default: 'lamp',
    description: 'Name of a preset, such as `wisp`. An unknown name uses the default.',
  },
  {
    name: 'src',
    type: string,
    description:
      'A share link of the demo page, which replaces `preset`. Its query parameters `t` and `paused` also apply; `paused` does not set the attribute, and `play()` overrides it. A new link restarts the smoke if it has `t` or a take, if `start` is set, or if the scene differs. Otherwise only the parameters change.',
  },
  {
    name: 'paused',
    type: flag,
    description:
      'Pauses the smoke. The button sets this attribute when the user pauses. If the page then removes it, the smoke stays paused.',
  },
  {
    name: 'transparent',
    type: flag,
    description: 'Makes the backdrop transparent, so that the page shows behind the smoke.',
  },
  {
    name: 'interactive',
    type: flag,
    description:
      'Handles pointer and key events. Drag moves an object of the scene or orbits the camera. Arrow keys orbit, a pinch, `+` and `-` zoom, `0` resets the view. The wheel and vertical swipes still scroll the page. Without this attribute, pointer events pass through the element.',
  },
  {
    name: 'start',
    type: { text: 'number' },
    description: 'Simulated seconds before the first frame, 0 to 600. Overrides the `t` of `src`.',
  },
  {
    name: 'alt',
    type: string,
    description: 'Text alternative of the canvas. An empty value marks the smoke as decorative.',
  },
  {
    name: 'label-play',
    type: string,
    default: 'Play smoke',
    description: 'Accessible name of the button while the smoke is paused.',
  },
  {
    name: 'label-pause',
    type: string,
    default: 'Pause smoke',
    description: 'Accessible name of the button while the smoke plays.',
  },
  {
    name: 'label-restart',
    type: string,
    default: 'Restart smoke',
    description: 'Accessible name of the button after the WebGL context was lost.',
  },
  {
    name: 'collide',
    type: string,
    description:
      'CSS selector. Smoke flows around the boxes of the matching elements and follows them when they move. At most eight elements apply: those inside the element and nearest to the emitters first. `statechange` reports when more match. Vortices curl the smoke at the ends of at most four.',
  },
  {
    name: 'emit-from',
    type: string,
    description:
      'CSS selector. Smoke rises from the top edges of the first eight matching elements. Use it with the preset `air`, which contains only smoke.',
  },
  {
    name: 'emit-on',
    type: { text: "'always' | 'hover' | 'click'" },
    default: 'always',
    description:
      'When the `emit-from` elements emit: always, while one is hovered or has keyboard focus, or for 0.9 s after a click. With `hover`, a tap also emits for 0.9 s.',
  },
  {
    name: 'loading',
    type: { text: "'lazy' | 'eager'" },
    default: 'lazy',
    description: '`lazy` loads the smoke when the element is within 400 px of the viewport, `eager` at once.',
  },
  {
    name: 'thread',
    type: { text: "'auto' | 'main' | 'worker'" },
    default: 'auto',
    description:
      'Thread that simulates and draws. `auto` uses a worker if the browser and the page allow it, otherwise the main thread.',
  },
];

export const events = [
  {
    name: 'ready',
    type: { text: "SmokeEvent<'ready'>" },
    description:
      'The first frame is drawn, or the first one after a restored context. `detail.thread` is `main` or `worker`.',
  },
  {
    name: 'error',
    type: { text: "SmokeEvent<'error'>" },
    description:
      'The smoke failed to start or stopped; `detail.error` has the reason. The poster and the fallback are shown.',
  },
  {
    name: 'statechange',
    type: { text: "SmokeEvent<'statechange'>" },
    description:
      'The smoke started or stopped playing (`detail.playing`), or an attribute value was replaced or ignored (`detail.notices`).',
  },
];

export const methods = [
  { name: 'play', description: 'Starts playing and removes `paused`.' },
  { name: 'pause', description: 'Stops playing and sets `paused`.' },
  { name: 'seek', description: 'Seeks to a simulated time in seconds.' },
  { name: 'step', description: 'Advances by whole steps of 1/60 s.' },
  {
    name: 'set',
    description:
      'Changes parameters by key, such as `{ "emission.rate": 60 }`. Rejects with a ParameterError if a value is out of range.',
  },
  { name: 'get', description: 'Resolves to all parameter values by key.' },
  { name: 'picture', description: 'Resolves to the current frame as a PNG.' },
  { name: 'stats', description: 'Resolves to statistics of the latest frame.' },
];

export const slots = [
  {
    name: 'poster',
    description:
      'Image shown until the first frame and after an error, scaled to cover the element. The image in a `<picture>` is as wide as the element, unless the page or its attributes set its size.',
  },
  { name: '', description: 'Fallback content, shown after an error and by browsers without JavaScript.' },
];

export const cssParts = [
  { name: 'frame', description: 'The box that contains all other parts.' },
  {
    name: 'canvas',
    description: 'The canvas. With `touch-action: none`, an interactive element also receives vertical swipes.',
  },
  { name: 'poster', description: 'The container of the poster.' },
  { name: 'fallback', description: 'The container of the fallback.' },
  { name: 'button', description: 'The button that pauses, plays and restarts.' },
];

export const cssProperties = [
  {
    name: '--cartoon-smoke-color',
    description:
      'Colour of the smoke in full light, any CSS colour. Overrides the colours of `preset` and `src`; the attribute `style-smoke-color` overrides it.',
  },
  { name: '--cartoon-smoke-ink', description: 'Colour of the lines, as `style-ink-color`.' },
  { name: '--cartoon-smoke-backdrop', description: 'Colour of the backdrop, as `style-backdrop` with one colour.' },
  { name: '--cartoon-smoke-button-size', default: '36px', description: 'Width and height of the button.' },
  { name: '--cartoon-smoke-button-inset', default: '10px', description: 'Distance of the button from the corner.' },
  { name: '--cartoon-smoke-button-color', default: '#1d1720', description: 'Icon and border colour of the button.' },
  { name: '--cartoon-smoke-button-background', default: '#fff8ecd9', description: 'Background colour of the button.' },
  { name: '--cartoon-smoke-focus-color', default: '#2f6fde', description: 'Colour of the focus ring.' },
];
