/** Runs in a page: the element, and a sandboxed frame. */
// oxlint-disable-next-line import/no-unassigned-import -- it defines the element
import '../../../src/element.ts';
import { morphBodyElements, morphElements } from '@hotwired/turbo';
import htmx from 'htmx.org';
import { Idiomorph } from 'idiomorph';
import morphdom from 'morphdom';
import { createElement } from 'react';
import { createRoot } from 'react-dom/client';
import { flushSync } from 'react-dom';
import type { CartoonSmokeElement } from '../../../src/page/element/cartoonSmokeElement.ts';
import { OnPage } from '../../../src/page/element/layout/onPage.ts';
import { PointerControls } from '../../../src/page/element/pointers.ts';
import type { Shell } from '../../../src/page/element/shell/shell.ts';
import { sizeOf, watchSize } from '../../../src/page/size.ts';
import { connectFrame } from '../../../src/stage/remote/connectFrame.ts';
import type { RemoteStage } from '../../../src/stage/remote/contract.ts';
import { packedFile } from './bytes.ts';

const SIZE = 'width: 160px; height: 120px';
const ATTRIBUTES = { 'simulation-max-particles': '300', 'puff-variations': '1', loading: 'eager', style: SIZE };

interface Played {
  thread: string;
  /** Steps during playback. */
  steps: number;
  /** A PNG, base64. */
  picture: string;
}

function put(attributes: Record<string, string>): CartoonSmokeElement {
  const element = document.createElement('cartoon-smoke');
  for (const [name, value] of Object.entries({ ...ATTRIBUTES, ...attributes })) element.setAttribute(name, value);
  document.body.append(element);
  return element;
}

async function play(stage: RemoteStage): Promise<Played> {
  const first = (await stage.stats()).steps;
  let steps = 0;
  while (steps < 30) {
    await new Promise((resolve) => setTimeout(resolve, 50));
    steps = (await stage.stats()).steps - first;
  }
  return { thread: stage.thread, steps, picture: await packedFile(await stage.picture()) };
}

/** Resolves after half a second of playback. */
export async function playElement(thread: 'auto' | 'main'): Promise<Played> {
  const element = put({ preset: 'wisp', thread, start: '2' });
  try {
    await element.ready;
    return await play(await element.stage);
  } finally {
    element.remove();
  }
}

/** The hash at the moment of a share link. */
export async function hashAtLink(link: string): Promise<{ hash: string; notices: readonly string[] }> {
  const notices: string[] = [];
  const element = document.createElement('cartoon-smoke');
  element.addEventListener('statechange', ({ detail }) =>
    notices.push(...detail.notices.map(({ message }) => message)),
  );
  element.setAttribute('style', SIZE);
  element.setAttribute('loading', 'eager');
  element.setAttribute('src', `${location.origin}/?paused=1${link}`);
  document.body.append(element);
  try {
    await element.ready;
    return { hash: await element.hash(), notices };
  } finally {
    element.remove();
  }
}

/** Resolves after half a second of playback in a frame with an opaque origin. */
export async function playFrame(address: string): Promise<Played> {
  const frame = document.createElement('iframe');
  frame.setAttribute('sandbox', 'allow-scripts');
  frame.setAttribute('style', `border: 0; ${SIZE}`);
  frame.src = address;
  document.body.append(frame);
  try {
    return await play(await connectFrame(frame));
  } finally {
    frame.remove();
  }
}

type Change = (element: CartoonSmokeElement, html: string) => unknown;

/** What pages do to elements that a user has paused or started. `html` is the element as the server sends it. */
const CHANGES: Record<string, Change> = {
  idiomorph: (element, html) => Idiomorph.morph(element, html),
  'idiomorph of the body': (_, html) => Idiomorph.morph(document.body, html, { morphStyle: 'innerHTML' }),
  morphdom: (element, html) => morphdom(element, html),
  'morphdom of the body': (_, html) => morphdom(document.body, `<body>${html}</body>`),
  'Turbo 8': (element, html) => morphElements(element, fragment(html).firstElementChild!),
  'Turbo 8 of the body': (_, html) => {
    const body = document.createElement('body');
    body.append(fragment(html));
    morphBodyElements(document.body, body);
  },
  // Its own algorithm, since version 4.
  'outerMorph of htmx': (element, html) => htmx.swap({ text: html, target: element, swap: 'outerMorph' }),
  'innerMorph of htmx of the body': (_, html) => htmx.swap({ text: html, target: document.body, swap: 'innerMorph' }),
  'outerSync of htmx': (element, html) => htmx.swap({ text: html, target: element, swap: 'outerSync' }),
  'React, another property': (element) => renderIn.get(element)!({ emissionLifetime: 3 }),
  'attributes in turn': (element, html) => {
    const next = fragment(html).firstElementChild!;
    for (const name of element.getAttributeNames()) if (!next.hasAttribute(name)) element.removeAttribute(name);
    for (const { name, value } of next.attributes)
      if (element.getAttribute(name) !== value) element.setAttribute(name, value);
  },
  'insertion elsewhere': (element) => document.body.append(document.createElement('div'), element),
  moveBefore: (element) => {
    const { body } = document as { body: { moveBefore?(node: Node, child: null): void } };
    body.moveBefore?.(element, null);
  },
  'adoption and return': (element) =>
    document.body.append(document.implementation.createHTMLDocument().adoptNode(element)),
};
/** What frameworks set while a state of theirs says that the smoke plays. */
const PLAYS: Record<string, Change> = {
  'the property paused': (element) => (element.paused = false),
  'the attribute paused': (element) => element.removeAttribute('paused'),
  'React, paused and then false': (element) => {
    for (const paused of [true, false]) renderIn.get(element)!({ paused });
  },
  'React, paused and then nothing': (element) => {
    for (const props of [{ paused: true }, {}]) renderIn.get(element)!(props);
  },
  'play() without a user gesture': (element) => {
    // Code that a test evaluates counts as user activation.
    Object.defineProperty(navigator, 'userActivation', { value: { isActive: false }, configurable: true });
    element.play();
    Reflect.deleteProperty(navigator, 'userActivation');
  },
};

/** How React renders its elements again, with these properties besides those of the first time. */
const renderIn = new WeakMap<Element, (props: object) => void>();

function putInReact(attributes: Record<string, string>): CartoonSmokeElement {
  const root = createRoot(document.body.appendChild(document.createElement('div')));
  const all = {
    ...ATTRIBUTES,
    ...attributes,
    ...('paused' in attributes && { paused: true }),
    style: { width: 160, height: 120 },
  };
  const render = (props: object) => flushSync(() => root.render(createElement('cartoon-smoke', { ...all, ...props })));
  render({});
  const element = document.body.lastElementChild!.firstElementChild as CartoonSmokeElement;
  renderIn.set(element, render);
  return element;
}

/** The element of a page that makes this change. */
const putFor = (change: string, attributes: Record<string, string>) =>
  (change.startsWith('React') ? putInReact : put)(attributes);

const fragment = (html: string) => document.createRange().createContextualFragment(html);

/** The changes of the page that undo a click on the button. */
async function overUser(changes: Record<string, Change>, attributes: Record<string, string>): Promise<string[]> {
  const wrong: string[] = [];
  for (const [name, change] of Object.entries(changes)) {
    const element = putFor(name, { preset: 'wisp', thread: 'main', ...attributes });
    const html = element.outerHTML;
    try {
      await element.ready;
      element.shadowRoot!.querySelector('button')!.click();
      await change(element, html);
      await element.ready;
      const [one] = document.querySelectorAll('cartoon-smoke');
      if (one !== element) throw new Error(`${name} replaced the element.`);
      if (element.playing !== 'paused' in attributes) wrong.push(name);
    } finally {
      element.remove();
      await new Promise((resolve) => setTimeout(resolve));
    }
  }
  return wrong;
}

/** The changes of the page that start smoke whose share link pauses it. */
async function overLink(attributes: Record<string, string>): Promise<string[]> {
  const wrong: string[] = [];
  for (const [name, change] of Object.entries(CHANGES)) {
    const element = putFor(name, { thread: 'main', ...attributes });
    const html = element.outerHTML;
    try {
      await element.ready;
      await change(element, html);
      if (element.playing) wrong.push(name);
    } finally {
      element.remove();
      await new Promise((resolve) => setTimeout(resolve));
    }
  }
  return wrong;
}

/** The changes that start smoke that the user has paused, and that pause smoke that the user has started. */
export async function changesOverUser(): Promise<string[]> {
  const link = { src: '?paused=1#preset=wisp' };
  return [
    ...(await overUser({ ...CHANGES, ...PLAYS }, {})),
    ...(await overLink(link)).map((name) => `${name}, paused by a link`),
    ...(await overUser(CHANGES, { paused: '' })).map((name) => `${name}, started`),
  ];
}

const SET = {
  seed: 5,
  'emission.rate': 77,
  'camera.azimuth': 40,
  'style.outlineWidth': 2.5,
  'vortices.0.circulation': 2,
};

/** The changes of the page that undo values which a call of set() has changed, or start the smoke again. */
export async function changesOverSet(): Promise<string[]> {
  const wrong: string[] = [];
  for (const [name, change] of Object.entries(CHANGES)) {
    const element = putFor(name, { preset: 'wisp', thread: 'main', 'emission-rate': '30' });
    const html = element.outerHTML.replace('preset=', 'emission-lifetime="3" preset=');
    try {
      await element.ready;
      await element.set(SET);
      await element.step(2);
      await change(element, html);
      await element.ready;
      let values: object = await element.get();
      // The new value arrives later.
      const wanted = element.hasAttribute('emission-lifetime') ? { ...SET, 'emission.lifetime': 3 } : SET;
      for (let at = 0; at < 20 && Reflect.get(values, 'emission.lifetime') !== 3; ++at) {
        await new Promise((resolve) => setTimeout(resolve, 10));
        values = await element.get();
      }
      const kept = Object.entries(wanted).every(([key, value]) => Reflect.get(values, key) === value);
      if (!kept || (await element.stats()).steps < 2) wrong.push(name);
    } finally {
      element.remove();
      await new Promise((resolve) => setTimeout(resolve));
    }
  }
  return wrong;
}

/** A stage that looks straight at a plane of 1 cm for each CSS pixel, and notes what it is told. */
function notingStage(notes: Record<string, unknown>): RemoteStage {
  const plane = { middle: [0, 0, 0], right: [0.01, 0, 0], up: [0, 0.01, 0] };
  const methods: Record<string, (given: never) => unknown> = {
    plane: () => plane,
    set: (values: object) => Object.assign(notes, values),
    pointer: (input: object) => Object.assign(notes, input),
  };
  return new Proxy({} as RemoteStage, {
    get: (_, name) => async (given: never) => methods[String(name)]?.(given),
  });
}

/**
 * What the element measures in a zoomed page: device pixels of its picture for each of the screen, a press at a quarter of
 * its box, and an obstacle at the same place.
 */
export async function measuredIn(styles: Readonly<Record<string, string>>) {
  document.body.innerHTML = `<div id="outer"><canvas style="position: absolute; left: 40px; top: 20px; width: 120px; height: 80px">
    </canvas><div id="box" style="position: absolute; left: 60px; top: 30px; width: 20px; height: 20px"></div></div>`;
  const canvas = document.querySelector('canvas')!;
  const measured: number[] = [];
  const stop = watchSize(canvas, ({ pixelRatio }) => measured.push(pixelRatio));
  for (const [selector, css] of Object.entries(styles))
    document.querySelector<HTMLElement>(selector)!.style.cssText += css;
  const notes: Record<string, unknown> = {};
  const stage = notingStage(notes);
  const container = document.body.appendChild(document.createElement('div'));
  new PointerControls(stage, { canvas, container } as unknown as Shell).toggle(true);
  canvas.setPointerCapture = () => undefined;
  // Hit tests know where an element is in client pixels in every browser.
  const edges = { left: Infinity, right: 0, top: Infinity, bottom: 0 };
  for (let y = 0; y < innerHeight; y += 2) {
    for (let x = 0; x < innerWidth; x += 2) {
      if (document.elementFromPoint(x, y) !== canvas) continue;
      edges.left = Math.min(edges.left, x);
      edges.right = Math.max(edges.right, x + 2);
      edges.top = Math.min(edges.top, y);
      edges.bottom = Math.max(edges.bottom, y + 2);
    }
  }
  const [width, height] = [edges.right - edges.left, edges.bottom - edges.top];
  const [clientX, clientY] = [edges.left + width / 4, edges.top + height / 4];
  canvas.dispatchEvent(new PointerEvent('pointerdown', { clientX, clientY, button: 0, bubbles: true }));
  const owner = Object.assign(document.createElement('div'), { id: 'owner' });
  owner.setAttribute('collide', '#box');
  document.body.append(owner);
  const onPage = new OnPage(stage, { element: owner, container: canvas, values: () => ({}), notify: () => undefined });
  await onPage.begin();
  const size = sizeOf(canvas);
  const found = {
    pixels: (size.width * size.pixelRatio) / width / devicePixelRatio,
    press: [notes.x, notes.y],
    obstacle: ['position.x', 'position.y', 'halfExtents.x'].map((key) => notes[`colliders.0.${key}`]),
  };
  onPage.dispose();
  stop();
  for (const each of [document.documentElement, document.body]) each.removeAttribute('style');
  return found;
}

/** A style sheet of the page, and the values that the smoke has with it. */
export interface CssCase {
  css: string;
  values: Readonly<Record<string, unknown>>;
}

/** The values of smoke beside style sheets of the page, each in place of the one before. */
export async function valuesByCss(cases: readonly CssCase[]): Promise<Readonly<Record<string, unknown>>[]> {
  const sheet = new CSSStyleSheet();
  document.adoptedStyleSheets.push(sheet);
  sheet.replaceSync(cases[0].css);
  const element = put({ preset: 'wisp', paused: '', 'style-ink-color': '#012345' });
  const seen: Readonly<Record<string, unknown>>[] = [];
  try {
    await element.ready;
    for (const { css, values } of cases) {
      sheet.replaceSync(css);
      const read = async () => {
        const all = (await element.get()) as Record<string, unknown>;
        return Object.fromEntries(Object.keys(values).map((key) => [key, all[key]]));
      };
      for (let tries = 0; tries < 400; tries++) {
        if (JSON.stringify(await read()) === JSON.stringify(values)) break;
        await new Promise((resolve) => setTimeout(resolve, 50));
      }
      seen.push(await read());
    }
  } finally {
    element.remove();
    document.adoptedStyleSheets.pop();
  }
  return seen;
}
