/** Smoke in frames, from the page around them. */
import { calls } from '../../src/remote/calls.ts';
import { connectFrame } from '../../src/remote/connectFrame.ts';
import type { RemoteStage } from '../../src/remote/contract.ts';
import { random as seeded } from '../visual/random.ts';

const SIZE = { width: 160, height: 120 };

export interface Framed {
  frame: HTMLIFrameElement;
  stage: RemoteStage;
}

/** Puts a frame on the page. @param sandbox without one, none */
export function frame(address: string, sandbox?: string): HTMLIFrameElement {
  const element = Object.assign(document.createElement('iframe'), SIZE, { src: address, title: 'Smoke' });
  element.style.border = '0';
  if (sandbox !== undefined) element.setAttribute('sandbox', sandbox);
  document.body.append(element);
  return element;
}

export async function connect(address: string, sandbox?: string): Promise<Framed> {
  const element = frame(address, sandbox);
  return { frame: element, stage: await connectFrame(element) };
}

/** Whether a frame that is there lets this page in, within some frames of the page. */
export async function letsIn(address: string): Promise<boolean> {
  const element = frame(address);
  await new Promise((resolve) => element.addEventListener('load', resolve));
  const patience = AbortSignal.timeout(3_000);
  return connectFrame(element, { signal: patience }).then(
    () => true,
    () => false,
  );
}

const STRANGE = [
  undefined,
  null,
  NaN,
  Infinity,
  -1,
  1e308,
  '',
  '__proto__',
  'constructor',
  'toString',
  'x'.repeat(1e5),
];
const METHODS = [
  ...Object.keys(calls),
  'listen',
  'unlisten',
  'dispose',
  '__proto__',
  'constructor',
  'then',
  'hasOwnProperty',
  '',
];

/** With an empty list of arguments these would do what they are for. */
const NO_ARGUMENTS = new Set(Object.keys(calls).filter((name) => calls[name as keyof typeof calls].takes.length === 0));
const NO_LISTS = [7, 'args', { length: 1e9 }, { 0: 1, length: 1 }, null];
const WRONG_LISTS = [[NaN], ['x'.repeat(1e4)], [{ 'emission.rate': 'many' }], [[{}]], [-Infinity], [new Uint8Array(9)]];

/** Messages that nobody means well with: wrong in shape, in size or in value, some of them almost right. */
export function* hostileMessages(count: number, seed: number): Generator {
  const random = seeded(seed);
  const pick = <Item>(items: readonly Item[]): Item => items[Math.floor(random() * items.length)];
  const junk = (depth = 0): unknown => {
    const kind = Math.floor(random() * (depth < 3 ? 7 : 5));
    if (kind < 2) return pick(STRANGE);
    if (kind === 2) return Math.floor((random() - 0.5) * 2 ** 32);
    if (kind === 3) return new Uint8Array(Math.floor(random() * 64)).map(() => random() * 256);
    if (kind === 4) return new Map([[pick(METHODS), 1]]);
    const inner = Array.from({ length: Math.floor(random() * 5) }, () => junk(depth + 1));
    return kind === 5 ? inner : Object.fromEntries(inner.map((each) => [pick(METHODS), each]));
  };
  const args = (method: string): unknown => {
    const needsNone = method === 'step' || !Object.hasOwn(calls, method) || NO_ARGUMENTS.has(method);
    return pick(needsNone ? NO_LISTS : [...NO_LISTS, ...WRONG_LISTS]);
  };
  for (let message = 0; message < count; ++message) {
    if (random() < 0.4) yield junk();
    else {
      const method = pick(METHODS);
      yield { id: pick([1, 2, 1e9, -1, 0.5, '1', null]), method, args: args(method), extra: junk() };
    }
  }
}

/** What hostile messages could have changed. */
export async function stateOf(stage: RemoteStage) {
  const { steps, alive } = await stage.stats();
  return { hash: await stage.hash(), values: await stage.get(), steps, alive };
}

/** Sends hostile messages to a frame's window and to a port of its own; how many answers were no refusals. */
export async function attack(element: HTMLIFrameElement, count: number): Promise<{ accepted: number; sent: number }> {
  const { port1, port2 } = new MessageChannel();
  const report = { accepted: 0, sent: 0 };
  let isOpen = () => {};
  const opened = new Promise<void>((resolve) => (isOpen = resolve));
  port1.onmessage = ({ data }: MessageEvent<{ id: number; error?: unknown }>) => {
    if (data.id === 0) return isOpen();
    if (!data.error) report.accepted += 1;
  };
  element.contentWindow!.postMessage({ cartoonSmoke: 'connect' }, '*', [port2]);
  await opened;
  for (const message of hostileMessages(count, 11)) {
    port1.postMessage(message);
    element.contentWindow!.postMessage(message, '*');
    report.sent += 1;
    // The frame has to have its turn, or everything waits in one heap.
    if (report.sent % 100 === 0) await new Promise((resolve) => setTimeout(resolve));
  }
  return report;
}
