/** `puff()` draws smoke, resolves when it is gone, and hides and shows elements. */
import { expect } from 'vitest';
import { test } from './fixtures.ts';

type Page = typeof import('./page/puff.ts');

test('puff draws smoke and resolves when it is gone', async ({ load }) => {
  const page = await load<Page>('/tests/engines/page/puff.ts');
  const { most, after, canvases, visibility } = await page.playPuff('poof');
  expect(most).toBeGreaterThan(20);
  expect(after).toBe(0);
  expect(canvases).toBe(1);
  expect(visibility).toBe('');
  const vanished = await page.playPuff('vanish');
  expect(vanished.most).toBeGreaterThan(20);
  expect(vanished.visibility).toBe('hidden');
});

const BOX = 'position: fixed; left: 160px; top: 120px; width: 80px; height: 40px';
const body = `<style>body { margin: 0 }</style><div id="outer"><div id="target" style="${BOX}"></div></div><p style="height: 3000px"></p>`;
const ZOOMS = [0.5, 1.25, 2];

const zoomed: [string, Record<string, string>][] = [
  ...ZOOMS.map((zoom): [string, Record<string, string>] => [`html ${zoom}`, { html: `zoom: ${zoom}` }]),
  ['body 0.9', { body: 'zoom: 0.9' }],
  ['box 2', { '#outer': 'zoom: 2' }],
  ['html 1.5, box 0.5', { html: 'zoom: 1.5', '#target': 'zoom: 0.5' }],
  ['transform of a box', { '#outer': 'transform: scale(1.5); transform-origin: 0 0' }],
  ['transform of the body', { body: 'transform: scale(.5); transform-origin: 0 0' }],
  ['html with position and margins', { html: 'position: relative; margin: 30px 0 0 50px' }],
];

for (const [name, styles] of zoomed) {
  test(`smoke is at its target with zoom or transform: ${name}`, async ({ load }) => {
    const page = await load<Page>('/tests/engines/page/puff.ts');
    // A box that is fixed within a transformed one scrolls away.
    for (const scrolled of [0, name.includes('transform') ? 40 : 400]) {
      const { off, isOver, pixels } = await page.placeOfSmoke({ body, styles }, scrolled);
      for (const each of off) expect(Math.abs(each)).toBeLessThan(1);
      expect(isOver).toBe(true);
      expect(pixels).toBeCloseTo(1, 1);
    }
  });
}

for (const [name, css, scroll] of [
  ['shorter', 'height: 6000px', [0, 5000]],
  ['narrower', 'width: 6000px; height: 10px', [4000, 0]],
  ['smaller, from right to left', 'width: 6000px; height: 6000px', [-4000, 5000], 'direction: rtl'],
  ['shorter, zoomed', 'height: 6000px', [0, 5000], 'zoom: 1.5'],
] as const) {
  test(`a document that gets ${name} during a puff is as without it`, async ({ load }) => {
    const page = await load<Page>('/tests/engines/page/puff.ts');
    const styles = { html: name.includes('right') ? 'direction: rtl' : name.includes('zoomed') ? 'zoom: 1.5' : '' };
    const [left, top] = scroll;
    const { scrolled, during, without } = await page.sizesOfShrunk(
      { body: `<div id="content" style="${css}"></div><p>Another page</p>`, styles },
      left,
      top,
    );
    expect(Math.abs(scrolled[0]) + scrolled[1]).toBeGreaterThan(3000);
    expect(during).toEqual(without);
    expect(Math.max(...during)).toBeLessThan(3000);
  });
}

for (const name of ['dialog', 'nested', 'shadow', 'slotted', 'popover', 'point'] as const) {
  test(`smoke of a target in the top layer is in it: ${name}`, async ({ load }) => {
    const page = await load<Page>('/tests/engines/page/puff.ts');
    const { during, backdrop, off, afterAct, after } = await page.topLayer(name);
    expect(during).toEqual({ isIn: true, isOpen: true, keepsFocus: true, rectangle: [0, 0, 0, 0] });
    // The page's rules for backdrops do not apply to the canvas.
    expect(backdrop).toBe('none');
    for (const each of off) expect(Math.abs(each)).toBeLessThan(1);
    // Also when the target is gone in mid-puff.
    expect(afterAct).toBe(true);
    expect(after).toBe(false);
  });
}

test('smoke joins the top layer when its target does, and not without', async ({ load }) => {
  const page = await load<Page>('/tests/engines/page/puff.ts');
  const late = await page.topLayer('late');
  expect([late.during.isIn, late.afterAct]).toEqual([false, true]);
  const plain = await page.topLayer('page');
  expect([plain.during.isIn, plain.afterAct]).toEqual([false, false]);
});

const ON_BUTTON = { box: [100, 80, 60, 20], id: 'button', inside: 'button', followsPointer: false };
const AT_CLICK = { box: [110, 90, 0, 0], id: null, inside: 'button', followsPointer: true };
const IN_FRAME = { box: [222, 132, 30, 40], id: 'inner', inside: 'inner', followsPointer: false };

const recognised = {
  element: ON_BUTTON,
  svg: { ...ON_BUTTON, box: [10, 10, 20, 20], id: 'circle', inside: 'circle' },
  text: ON_BUTTON,
  ref: ON_BUTTON,
  vueRef: ON_BUTTON,
  component: ON_BUTTON,
  angularRef: ON_BUTTON,
  jQuery: ON_BUTTON,
  nodeList: ON_BUTTON,
  event: AT_CLICK,
  reactEvent: AT_CLICK,
  reactKeyboard: ON_BUTTON,
  jQueryEvent: AT_CLICK,
  reactRefOfFrame: IN_FRAME,
  inFrame: IN_FRAME,
  inZoomedFrame: { ...IN_FRAME, box: [444, 264, 60, 80] },
  inScaledFrame: { ...IN_FRAME, box: [244, 164, 60, 80] },
  inScrolledFrame: { ...IN_FRAME, box: [222, 117, 30, 40] },
  eventInFrame: { box: [227, 137, 0, 0], id: null, inside: 'inner', followsPointer: true },
  point: { box: [3, 4, 0, 0], id: null, inside: null, followsPointer: false },
  emptyRef: 'target cannot be',
  emptyList: 'target cannot be',
  selector: 'target cannot be “#button”',
  number: 'target cannot be 5',
} as const;

test('targets are recognised by their shape', async ({ load }) => {
  const page = await load<Page>('/tests/engines/page/puff.ts');
  for (const [name, expected] of Object.entries(recognised)) {
    const found = await page.recognised(name as keyof typeof recognised);
    if (typeof expected === 'string') expect(found, name).toContain(expected);
    else expect(found, name).toEqual(expected);
  }
});

test('calls that nobody awaits cause no unhandled rejection', async ({ load }) => {
  const page = await load<Page>('/tests/engines/page/puff.ts');
  expect(await page.unhandled()).toEqual({ count: 0, caught: ['ParameterError', 'ParameterError'] });
});

const colors = {
  tomato: '#ff6347',
  '#08f8': '#0088ff',
  'rgb(255 99 71 / 50%)': '#ff6347',
  'hsl(120deg 100% 25%)': '#008000',
  'hwb(240 0% 0%)': '#0000ff',
  'lab(50% 0 0)': '#777777',
  'oklch(0.6279 0.2577 29.23)': '#ff0000',
  'color(display-p3 1 0 0)': '#ff0000',
  'color(srgb 0 .5 1)': '#0080ff',
  'color-mix(in srgb, red, blue)': '#800080',
  'rgb(from tomato b g r)': '#4763ff',
  currentColor: '#123456',
  'var(--brand)': '#fedcba',
  'var(--deep)': '#fedcba',
  'var(--none, #abcdef)': '#abcdef',
  'color-mix(in srgb, var(--brand) 100%, black)': '#fedcba',
  'light-dark(red, blue)': '#0000ff',
  transparent: '#000000',
};

test('colours are what the CSS parser says', async ({ load }) => {
  const page = await load<Page>('/tests/engines/page/puff.ts');
  const found = await page.hexes(Object.keys(colors));
  expect(Object.fromEntries(Object.keys(colors).map((color, at) => [color, found[at]]))).toEqual(colors);
});

const styled = {
  'no style': ['', ''],
  'inline opacity': ['opacity: 0.3', ''],
  'opacity of a rule': ['', '#p { opacity: 0.3 }'],
  transitions: ['', '* { transition: all 1s; opacity: 0.9 }'],
  'transitions with a delay': ['', '* { transition: all 1s 1s; opacity: 0.9 }'],
  'an animation': ['', '@keyframes dim { from, to { opacity: 0.4 } } #p { animation: dim 1s infinite }'],
  'a transform': ['transform: rotate(3deg); color: red', ''],
  'inline visibility': ['visibility: visible', ''],
  'important visibility': ['', '#p { visibility: visible !important }'],
  'important inline visibility': ['visibility: visible !important; opacity: 0.5', ''],
} as const;

for (const [name, [css, rules]] of Object.entries(styled)) {
  test(`vanish begins and appear ends at the opacity of the page: ${name}`, async ({ load }) => {
    const page = await load<Page>('/tests/engines/page/puff.ts');
    for (const end of ['finish', 'clear'] as const) {
      const vanish = await page.fades('vanish', css, rules, end);
      expect(vanish.most, 'vanish').toBeLessThanOrEqual(vanish.usual + 0.01);
      expect(vanish.first, 'vanish').toBeCloseTo(vanish.usual, 1);
      expect(vanish).toMatchObject({ last: 0, isKept: true, animations: 0 });
      const appear = await page.fades('appear', css, rules, end);
      expect(appear.most, 'appear').toBeLessThanOrEqual(appear.usual + 0.01);
      expect(appear.last, 'appear').toBeCloseTo(appear.usual, 2);
      expect(appear).toMatchObject({ first: 0, isKept: true, animations: 0 });
    }
  });
}
