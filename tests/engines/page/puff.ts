/** Runs in a page: `puff()`. */
import { puff, type Effect } from '../../../src/puff.ts';
import { hexOf } from '../../../src/page/puff/look.ts';
import { sourceOf } from '../../../src/page/puff/target.ts';
import { visibilityChange } from '../../../src/page/puff/puff.ts';

interface Played {
  /** Largest number of opaque pixels of a small copy of the canvas during the call. */
  most: number;
  /** The same after it. */
  after: number;
  canvases: number;
  visibility: string;
}

const WIDTH = 64;
const HEIGHT = 48;

/** Resolves when the smoke of a call on a box is gone. */
export async function playPuff(effect: Effect): Promise<Played> {
  const box = document.createElement('div');
  box.setAttribute('style', 'position: fixed; left: 40%; top: 40%; width: 60px; height: 30px');
  document.body.append(box);
  let most = 0;
  // After the stage's own callback of the frame: WebKitGTK draws on the canvas itself, which is empty after the frame.
  const timer = setInterval(() => requestAnimationFrame(() => (most = Math.max(most, opaque()))), 20);
  await puff(box, { effect, count: 30, duration: 2, seed: 5 });
  clearInterval(timer);
  // The last picture may be on its way from the worker.
  for (let frame = 0; frame < 5; ++frame) await new Promise(requestAnimationFrame);
  const { visibility } = box.style;
  box.remove();
  return { most, after: opaque(), canvases: document.querySelectorAll('canvas').length, visibility };
}

function opaque(): number {
  const canvas = document.querySelector('canvas');
  if (!canvas?.width || !canvas.height) return 0;
  const copy = Object.assign(document.createElement('canvas'), { width: WIDTH, height: HEIGHT }).getContext('2d')!;
  copy.drawImage(canvas, 0, 0, WIDTH, HEIGHT);
  const { data } = copy.getImageData(0, 0, WIDTH, HEIGHT);
  return data.filter((byte, at) => at % 4 === 3 && byte > 128).length;
}

// After the stage's own callback of the frame: WebKitGTK draws on the canvas itself, which is empty after the frame.
const nextFrame = () => new Promise((resolve) => setTimeout(() => requestAnimationFrame(resolve)));
/** Smoke that stays about where it starts. */
const STILL = { count: 120, speed: 0.05, duration: 12, seed: 5 } as const;
const html = document.documentElement;

/** Body and style attributes by selector. */
interface Scenery {
  readonly body?: string;
  readonly styles?: Readonly<Record<string, string>>;
}

function build({ body = '', styles = {} }: Scenery): void {
  scrollTo(0, 0);
  html.removeAttribute('style');
  document.body.removeAttribute('style');
  document.body.innerHTML = body;
  for (const [selector, css] of Object.entries(styles))
    document.querySelector<HTMLElement>(selector)!.style.cssText += css;
}

type Box = Pick<DOMRect, 'left' | 'top' | 'width' | 'height'>;

/** What is hit, because browsers disagree on the rectangles of zoomed elements. */
function clientRect(element: Element): Box {
  let [left, top, right, bottom] = [Infinity, Infinity, 0, 0];
  for (let y = 0; y < innerHeight; y += 4) {
    for (let x = 0; x < innerWidth; x += 4) {
      if (document.elementFromPoint(x, y) !== element) continue;
      [left, top, right, bottom] = [
        Math.min(left, x),
        Math.min(top, y),
        Math.max(right, x + 4),
        Math.max(bottom, y + 4),
      ];
    }
  }
  return { left, top, width: right - left, height: bottom - top };
}

/** Whether the canvas is under each corner of the window. */
function fillsWindow(canvas: HTMLCanvasElement): boolean {
  const { clientWidth, clientHeight } = html;
  canvas.style.setProperty('pointer-events', 'auto', 'important');
  // Overlay scroll bars of Firefox are in front, for a while after scrolling.
  const hits = [1, clientWidth - 2].flatMap((x) => [1, clientHeight - 2].map((y) => document.elementsFromPoint(x, y)));
  canvas.style.setProperty('pointer-events', 'none', 'important');
  return hits.every((each) => each.includes(canvas));
}

/** The middle of the smoke in client pixels, over some frames, because a single one has few puffs. */
async function middleOfSmoke(call: Promise<void>): Promise<{ x: number; y: number }> {
  let [sum, x, y, frames] = [0, 0, 0, 0];
  const state = { isOver: false };
  call.then(() => (state.isOver = true)).catch(() => undefined);
  for (;;) {
    await nextFrame();
    const canvas = document.querySelector('canvas');
    if (!canvas?.width || !canvas.height) continue;
    const copy = Object.assign(document.createElement('canvas'), { width: WIDTH, height: HEIGHT }).getContext('2d')!;
    copy.drawImage(canvas, 0, 0, WIDTH, HEIGHT);
    const { data } = copy.getImageData(0, 0, WIDTH, HEIGHT);
    const before = sum;
    for (let at = 0; at < WIDTH * HEIGHT; ++at) {
      const weight = data[4 * at + 3];
      sum += weight;
      x += weight * ((at % WIDTH) + 0.5);
      y += weight * (Math.floor(at / WIDTH) + 0.5);
    }
    // The first frames have few puffs.
    if (sum > before && ++frames === 8) [sum, x, y] = [0, 0, 0];
    if (frames < 20 && !state.isOver) continue;
    return { x: (x / sum / WIDTH) * html.clientWidth, y: (y / sum / HEIGHT) * html.clientHeight };
  }
}

async function clear(call: Promise<void>): Promise<void> {
  puff.clear();
  await call;
  do await nextFrame();
  while (opaque() > 0);
}

/** Offset of smoke from a box, relative to the box and its surroundings, in which the puffs are anywhere. */
const offset = ({ x, y }: { x: number; y: number }, box: Box) => [
  (x - box.left - box.width / 2) / (60 + box.width / 3),
  (y - box.top - box.height / 2) / (60 + box.height / 3),
];

/** Where the smoke and the canvas of a call on `#target` are. */
export async function placeOfSmoke(scenery: Scenery, scrolled = 0) {
  build(scenery);
  scrollTo(0, scrolled);
  const target = document.querySelector('#target')!;
  const call = puff(target, STILL);
  const smoke = await middleOfSmoke(call);
  const box = clientRect(target);
  const canvas = document.querySelector('canvas')!;
  const isOver = fillsWindow(canvas);
  await clear(call);
  return {
    off: offset(smoke, box),
    isOver,
    pixels: canvas.width / html.clientWidth / Math.min(devicePixelRatio, 2),
  };
}

/** Sizes of a document that gets smaller while there is smoke, and those of the same document without smoke. */
export async function sizesOfShrunk(scenery: Scenery, left: number, top: number) {
  build(scenery);
  html.dir = (scenery.styles ?? {}).html?.includes('rtl') ? 'rtl' : 'ltr';
  scrollTo(left, top);
  const scrolled = [Math.round(scrollX), Math.round(scrollY)];
  const call = puff(undefined, STILL);
  await middleOfSmoke(call);
  document.querySelector('#content')!.remove();
  await nextFrame();
  const during = [html.scrollWidth, html.scrollHeight];
  puff.clear();
  await call;
  // The canvas goes when it is not used any more.
  while (document.querySelector('canvas')) await nextFrame();
  const without = [html.scrollWidth, html.scrollHeight];
  html.dir = '';
  return { scrolled, during, without };
}

const isInTopLayer = () => {
  const canvas = document.querySelector('canvas');
  const frame = canvas?.assignedSlot?.parentElement ?? canvas?.parentElement;
  return frame?.matches(':popover-open') ?? false;
};

/** The canvas and the page while smoke leaves something in the top layer, after the `act`, and after the smoke. */
export async function topLayer(name: keyof typeof topLayers) {
  build({ body: '<button id="outside">Outside</button><p style="height: 3000px">Text</p>' });
  const style = Object.assign(document.createElement('style'), {
    textContent: '::backdrop { backdrop-filter: blur(0px); background: linear-gradient(red, blue) }',
  });
  document.body.append(style);
  const { target, focused, isOpen = () => true, act = () => undefined } = topLayers[name]();
  focused?.focus();
  const states = () => ({
    isIn: isInTopLayer(),
    isOpen: isOpen(),
    keepsFocus: !focused || document.activeElement === focused,
  });
  const call = puff(target, STILL);
  const smoke = await middleOfSmoke(call);
  const canvas = document.querySelector('canvas')!;
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const during = { ...states(), rectangle: [left, top, width - html.clientWidth, height - html.clientHeight] };
  const frame = canvas.assignedSlot?.parentElement ?? canvas;
  const backdrop = getComputedStyle(frame, '::backdrop').backdropFilter ?? 'none';
  const off = target instanceof Element ? offset(smoke, target.getBoundingClientRect()) : [];
  act();
  await nextFrame();
  const { isIn } = states();
  await clear(call);
  const plain = puff(document.querySelector('#outside'), STILL);
  await middleOfSmoke(plain);
  const after = isInTopLayer();
  await clear(plain);
  for (const each of document.querySelectorAll('dialog')) each.close();
  return { during, backdrop, off, afterAct: isIn, after };
}

interface TopLayer {
  readonly target: Element | { x: number; y: number } | undefined;
  readonly focused?: HTMLElement;
  readonly isOpen?: () => boolean;
  readonly act?: () => void;
}

function dialogIn(parent: ParentNode, text = ''): HTMLDialogElement {
  const dialog = document.createElement('dialog');
  dialog.innerHTML = `<input><button class="target">Press ${text}</button>`;
  parent.append(dialog);
  dialog.showModal();
  return dialog;
}

const topLayers = {
  dialog(): TopLayer {
    const dialog = dialogIn(document.body);
    return {
      target: dialog.querySelector('.target')!,
      focused: dialog.querySelector('input')!,
      isOpen: () => dialog.open,
      act: () => dialog.close(),
    };
  },
  nested(): TopLayer {
    const outer = dialogIn(document.body);
    const inner = dialogIn(outer, 'inner');
    return {
      target: inner.querySelector('.target')!,
      isOpen: () => outer.open && inner.open,
      act: () => inner.close(),
    };
  },
  shadow(): TopLayer {
    const root = document.body.appendChild(document.createElement('div')).attachShadow({ mode: 'open' });
    const dialog = dialogIn(root);
    const inner = dialog.appendChild(document.createElement('div')).attachShadow({ mode: 'open' });
    inner.innerHTML = '<button>Press</button>';
    return { target: inner.querySelector('button')!, isOpen: () => dialog.open };
  },
  slotted(): TopLayer {
    const host = document.body.appendChild(document.createElement('div'));
    host.innerHTML = '<button>Press</button>';
    const root = host.attachShadow({ mode: 'open' });
    root.innerHTML = '<dialog><slot></slot></dialog>';
    root.querySelector('dialog')!.showModal();
    return { target: host.querySelector('button')! };
  },
  popover(): TopLayer {
    const popover = document.body.appendChild(document.createElement('div'));
    popover.popover = 'auto';
    popover.innerHTML = '<button>Press</button>';
    popover.showPopover();
    return { target: popover.querySelector('button')!, isOpen: () => popover.matches(':popover-open') };
  },
  /** A point counts as what is under it. */
  point(): TopLayer {
    const { left, top } = dialogIn(document.body).querySelector('.target')!.getBoundingClientRect();
    return { target: { x: left + 5, y: top + 5 } };
  },
  /** Opened while its content is smoking. */
  late(): TopLayer {
    const popover = document.body.appendChild(document.createElement('div'));
    popover.setAttribute('style', 'position: absolute; left: 300px; top: 200px');
    popover.innerHTML = '<button>Press</button>';
    return {
      target: popover.querySelector('button')!,
      act() {
        popover.popover = 'manual';
        popover.showPopover();
      },
    };
  },
  /** Opened again while its content is smoking. */
  page(): TopLayer {
    return { target: document.querySelector('#outside')! };
  },
};

/** What a call takes a target for. Each is made as a page, a library or another window gives it. */
export async function recognised(name: keyof typeof targets) {
  build({
    body: `<style>body { margin: 0 } button { position: absolute; left: 100px; top: 80px; width: 60px; height: 20px }</style>
    <button id="button">Press</button><svg width="40" height="40"><circle id="circle" cx="20" cy="20" r="10"/></svg>
    <iframe srcdoc="<!doctype html><style>body { margin: 0 }</style><button id=inner style='position: absolute; left: 10px; top: 20px; width: 30px; height: 40px'></button><p style='height: 999px'>"
      style="position: absolute; left: 200px; top: 100px; border: 5px solid; padding: 7px; width: 150px; height: 120px"></iframe>`,
  });
  const frame = document.querySelector('iframe')!;
  await new Promise((resolve) => frame.addEventListener('load', resolve, { once: true }));
  try {
    const { box, element, inside, followsPointer } = sourceOf(targets[name](frame) as never);
    const { left, top, width, height } = box() ?? { left: NaN, top: NaN, width: NaN, height: NaN };
    return {
      box: [left, top, width, height].map(Math.round),
      id: element?.id ?? null,
      inside: inside?.id ?? null,
      followsPointer,
    };
  } catch (error) {
    return (error as Error).message;
  }
}

const button = () => document.querySelector('#button')!;

/** The event that a listener gets. */
function fired(target: EventTarget, event: Event): Event {
  let got: Event | undefined;
  target.addEventListener(event.type, (each) => (got = each), { once: true });
  target.dispatchEvent(event);
  return got!;
}

/** An event as React passes it on. */
function synthetic(native: Event, currentTarget: Element | null) {
  const { clientX, clientY } = native as MouseEvent;
  return { nativeEvent: native, currentTarget, target: native.target, type: native.type, clientX, clientY };
}

const CLICK = { clientX: 110, clientY: 90, bubbles: true };

const targets = {
  element: () => button(),
  svg: () => document.querySelector('#circle'),
  text: () => button().firstChild,
  ref: () => ({ current: button() }),
  vueRef: () => ({ value: button() }),
  component: () => ({ $el: button() }),
  angularRef: () => ({ nativeElement: button() }),
  jQuery: () => ({ 0: button(), length: 1, jquery: '3.7.1' }),
  nodeList: () => document.querySelectorAll('#button'),
  event: () => fired(button(), new MouseEvent('click', CLICK)),
  reactEvent: () => synthetic(fired(button(), new MouseEvent('click', CLICK)), button()),
  reactKeyboard: () => synthetic(fired(button(), new MouseEvent('click', { bubbles: true })), button()),
  jQueryEvent: () => ({
    ...synthetic(new MouseEvent('click', CLICK), button()),
    nativeEvent: undefined,
    originalEvent: fired(button(), new MouseEvent('click', CLICK)),
  }),
  reactRefOfFrame: (frame: HTMLIFrameElement) => ({ current: frame.contentDocument!.querySelector('#inner') }),
  inFrame: (frame: HTMLIFrameElement) => frame.contentDocument!.querySelector('#inner'),
  inZoomedFrame: (frame: HTMLIFrameElement) => {
    frame.style.zoom = '2';
    return frame.contentDocument!.querySelector('#inner');
  },
  inScaledFrame: (frame: HTMLIFrameElement) => {
    frame.style.cssText += 'transform: scale(2); transform-origin: 0 0';
    return frame.contentDocument!.querySelector('#inner');
  },
  inScrolledFrame: (frame: HTMLIFrameElement) => {
    frame.contentWindow!.scrollTo(0, 15);
    return frame.contentDocument!.querySelector('#inner');
  },
  eventInFrame: (frame: HTMLIFrameElement) => {
    const { MouseEvent: Event } = frame.contentWindow as typeof globalThis & Window;
    return fired(frame.contentDocument!.querySelector('#inner')!, new Event('click', { clientX: 15, clientY: 25 }));
  },
  point: () => ({ x: 3, y: 4 }),
  emptyRef: () => ({ current: null }),
  emptyList: () => [],
  selector: () => '#button',
  number: () => 5,
};

/** Un-awaited calls that reject, and what those who await them get. */
export async function unhandled() {
  let count = 0;
  const listen = () => ++count;
  addEventListener('unhandledrejection', listen);
  const calls = [puff('button' as never), puff(undefined, { count: -1 })];
  await new Promise((resolve) => setTimeout(resolve, 100));
  removeEventListener('unhandledrejection', listen);
  const caught = await Promise.all(calls.map((call) => call.catch(({ name }: Error) => name)));
  return { count, caught };
}

/** `#rrggbb` of CSS colours where a browser falsifies the pixels of canvases against fingerprinting. */
export function hexes(colors: readonly string[]): string[] {
  const { prototype } = CanvasRenderingContext2D;
  const native = prototype.getImageData;
  prototype.getImageData = function (...given) {
    const image = native.apply(this, given);
    image.data.fill(77);
    return image;
  };
  build({ body: '<p style="color: #123456; --brand: #fedcba; --deep: var(--brand); color-scheme: dark">Text</p>' });
  try {
    return colors.map((color) => hexOf(color, document.querySelector('p')!));
  } finally {
    prototype.getImageData = native;
  }
}

/** Opacities that an element shows while it vanishes or appears, and its style attribute before and after. */
export async function fades(effect: 'vanish' | 'appear', css: string, rules = '', end: 'finish' | 'clear' = 'finish') {
  build({ body: `<style>${rules}</style><p id="p"><b>Text</b></p>` });
  const element = document.querySelector<HTMLElement>('#p')!;
  element.style.cssText = css;
  const declared = () => element.style.cssText.split(/; ?/).sort().join();
  const before = declared();
  const usual = Number(getComputedStyle(element).opacity);
  if (effect === 'appear') {
    const hidden = visibilityChange('vanish', element);
    hidden.end();
  }
  const shown = () => {
    const { opacity, visibility } = getComputedStyle(element);
    const child = getComputedStyle(element.querySelector('b')!).visibility;
    return visibility === 'visible' || child === 'visible' ? Number(opacity) : 0;
  };
  const seen = [shown()];
  const change = visibilityChange(effect, element);
  change.begin();
  const state = { isOver: false };
  const over = change.finished().then(() => (state.isOver = true));
  seen.push(shown());
  while (!state.isOver) {
    await nextFrame();
    seen.push(shown());
    if (end === 'clear' && seen.length > 10) change.end();
  }
  await over;
  for (let frame = 0; frame < 4; ++frame) {
    await nextFrame();
    seen.push(shown());
  }
  const after = declared();
  // What `vanish` has changed is back after an `appear`.
  if (effect === 'vanish') visibilityChange('appear', element).end();
  return {
    usual,
    first: seen[1],
    most: Math.max(...seen),
    last: seen.at(-1),
    isKept: (effect === 'vanish' ? declared() : after) === before,
    animations: element.getAnimations().filter((each) => !('animationName' in each)).length,
  };
}
