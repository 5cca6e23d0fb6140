/** In environments that cannot draw, such as the simulated DOMs of unit tests, everything is inert. */
import { Window } from 'happy-dom';
import { JSDOM, VirtualConsole } from 'jsdom';
import { parseHTML } from 'linkedom';
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { populateGlobal } from 'vitest/environments';
import type { CartoonSmokeElement } from '../../../../src/page/element/cartoonSmokeElement.ts';

const complaints: unknown[] = [];
const note = (...complaint: unknown[]) => void complaints.push(complaint);

function jsdom(): object {
  const virtualConsole = new VirtualConsole();
  for (const kind of ['error', 'warn'] as const) virtualConsole.on(kind, note);
  virtualConsole.on('jsdomError', note);
  return new JSDOM('', { pretendToBeVisual: true, url: 'http://localhost/', virtualConsole }).window;
}

const WHOLE: Record<string, () => object> = {
  jsdom,
  'happy-dom': () => new Window({ url: 'http://localhost/' }),
  linkedom: () => parseHTML('<!doctype html><html><body></body></html>'),
};
const REMOVED = [
  ['matchMedia'],
  ['ResizeObserver'],
  ['IntersectionObserver'],
  ['MutationObserver'],
  ['CSSStyleSheet'],
  ['WebAssembly'],
  ['Worker', 'OffscreenCanvas'],
  ['requestAnimationFrame'],
];
const ENVIRONMENTS: [string, () => object, readonly string[]][] = [
  ['Node without a DOM', () => ({}), []],
  ...Object.entries(WHOLE).flatMap(([name, open]): [string, () => object, readonly string[]][] => [
    [name, open, []],
    ...REMOVED.map((removed): [string, () => object, readonly string[]] => [
      `${name} without ${removed.join(', ')}`,
      open,
      removed,
    ]),
  ]),
];

const originals = new Map<string, PropertyDescriptor | undefined>();

function define(name: string, value: unknown): void {
  if (!originals.has(name)) originals.set(name, Object.getOwnPropertyDescriptor(globalThis, name));
  Object.defineProperty(globalThis, name, { configurable: true, writable: true, value });
}

/** Gives Node the globals of a window. */
function enter(window: object, removed: readonly string[]): void {
  const before = new Set(Object.getOwnPropertyNames(globalThis));
  if ('document' in window) {
    define('document', window.document);
    define('customElements', Reflect.get(window, 'customElements'));
    const { keys } = populateGlobal(globalThis, window, { bindFunctions: true });
    for (const key of keys) if (!before.has(key) && !originals.has(key)) originals.set(key, undefined);
    // linkedom has them only on its window.
    for (const name of ['HTMLElement', 'Element', 'Event', 'CustomEvent', 'SVGElement', 'Node'])
      define(name, Reflect.get(window, name));
  }
  for (const name of removed) define(name, undefined);
  for (const name of removed) Reflect.deleteProperty(globalThis, name);
}

beforeEach(() => {
  vi.resetModules();
  complaints.length = 0;
  process.on('unhandledRejection', note);
  for (const method of ['error', 'warn', 'log', 'info'] as const) vi.spyOn(console, method).mockImplementation(note);
});

afterEach(() => {
  process.off('unhandledRejection', note);
  vi.restoreAllMocks();
  for (const [name, descriptor] of originals) {
    if (descriptor) Object.defineProperty(globalThis, name, descriptor);
    else Reflect.deleteProperty(globalThis, name);
  }
  originals.clear();
});

async function useElement(): Promise<void> {
  const { CartoonSmokeElement: Defined } = await import('../../../../src/page/element/define.ts');
  if (!globalThis.document) return;
  document.body.innerHTML = '<cartoon-smoke preset="wisp"><p slot="poster">Poster</p></cartoon-smoke>';
  const made = document.createElement('cartoon-smoke');
  expect(made).toBeInstanceOf(Defined);
  for (const element of [made, document.querySelector('cartoon-smoke')!]) await useEverything(element);
}

async function useEverything(element: CartoonSmokeElement): Promise<void> {
  const failures: unknown[] = [];
  element.addEventListener('error', ({ detail }) => failures.push(detail.error));
  Object.assign(element, { preset: 'lamp', emissionRate: 40, paused: true, transparent: true, loading: 'eager' });
  element.setAttribute('src', '#v=1&preset=wisp');
  element.setAttribute('collide', 'p');
  document.body.append(element);
  element.play();
  element.pause();
  await Promise.all([element.seek(2), element.set({ 'emission.rate': 4 }), element.stats(), element.ready]);
  void element.stage;
  expect(element.playing).toBe(false);
  element.removeAttribute('paused');
  const copy = element.cloneNode(true) as Element;
  element.replaceWith(copy);
  copy.remove();
  document.body.append(element);
  expect(failures).toEqual([]);
}

async function usePuff(): Promise<void> {
  const { puff } = await import('../../../../src/puff.ts');
  await puff();
  await puff({ x: 3, y: 4 }, { effect: 'burst' });
  await puff.preload();
  puff.clear();
  if (!globalThis.document) return;
  const button = document.createElement('button');
  document.body.append(button);
  await puff(button);
  await puff(button, { reducedMotion: 'play', preset: 'lamp' });
  await puff(button, { effect: 'vanish' });
  expect(button.style.visibility).toBe('hidden');
  await puff(button, { effect: 'appear' });
  expect(button.style.visibility).not.toBe('hidden');
  const own = puff.create(document.createElement('canvas'));
  await own(button);
  own.dispose();
}

describe.each(ENVIRONMENTS)('%s', (_, open, removed) => {
  beforeEach(() => enter(open(), removed));

  test.each([
    ['<cartoon-smoke>', useElement],
    ['puff()', usePuff],
    [
      'the other entries',
      // One after the other: React Three Fiber requires three.js, which Node cannot do while it imports it.
      async () => {
        await import('../../../../src/index.ts');
        await import('../../../../src/fiber.ts');
      },
    ],
  ])('%s', async (_name, act) => {
    await act();
    // Late rejections, too.
    await new Promise((resolve) => setImmediate(resolve));
    expect(complaints).toEqual([]);
  });
});
