/** Smoke in iframes, from the parent page. */
import { connectFrame } from '../../../../src/stage/remote/connectFrame.ts';
import { SimulatorError } from '../../../../src/base/errors.ts';
import type { RemoteStage } from '../../../../src/stage/remote/contract.ts';
import { hostileMessages } from '../../../support/hostileMessages.ts';

const SIZE = { width: 160, height: 120 };

export interface Framed {
  frame: HTMLIFrameElement;
  stage: RemoteStage;
}

/** Adds an iframe to the page. @param sandbox absent: no sandbox @param isShaded whether it is in a shadow tree */
export function frame(address: string, sandbox?: string, isShaded = false): HTMLIFrameElement {
  const element = Object.assign(document.createElement('iframe'), SIZE, { src: address, title: 'Smoke' });
  element.style.border = '0';
  if (sandbox !== undefined) element.setAttribute('sandbox', sandbox);
  const place = isShaded ? document.createElement('div').attachShadow({ mode: 'open' }) : document.body;
  if (place instanceof ShadowRoot) document.body.append(place.host);
  place.append(element);
  return element;
}

export async function connect(address: string, sandbox?: string, origin?: string, isShaded?: boolean): Promise<Framed> {
  const element = frame(address, sandbox, isShaded);
  return { frame: element, stage: await connectFrame(element, { origin }) };
}

/** What a frame says to a model, and how many puffs of its smoke live after a second. */
export async function withoutModel(address: string, bytes: readonly number[]) {
  const { stage } = await connect(address);
  const error = await stage.setModel(Uint8Array.from(bytes)).catch((reason: Error) => reason);
  await stage.step(60);
  const { alive } = await stage.stats();
  return { name: error instanceof Error && error.name, message: error instanceof Error && error.message, alive };
}

/**
 * One of two connections disposes the smoke: the notice to the other one, and the steps that a third connection sees.
 */
export async function endsAndBegins(address: string): Promise<{ other: string; steps: number }> {
  const { frame: element, stage } = await connect(address);
  const other = await connectFrame(element);
  await other.step(5);
  await stage.dispose();
  // The notice travels on another port.
  let notified: string | undefined;
  while (!notified) {
    notified = await other.hash().then(
      () => undefined,
      ({ name }: Error) => name,
    );
  }
  const { steps } = await (await connectFrame(element)).stats();
  return { other: notified, steps };
}

/** Ways in which the parent page removes or replaces an iframe. */
const ENDINGS: Readonly<Record<string, (frame: HTMLIFrameElement) => void>> = {
  removed: (element) => element.remove(),
  moved: (element) => document.body.prepend(element),
  'removed with what is around it': (element) => (element.getRootNode() as ShadowRoot).host.remove(),
  'sent elsewhere': (element) => (element.src = 'about:blank'),
  // Browsers end a page that is busy for longer than about a second without a pagehide event.
  'sent elsewhere while busy': (element) => {
    element.contentWindow?.postMessage({ busyFor: 4_000 }, '*');
    setTimeout(() => (element.src = 'about:blank'), 200);
  },
};

/** Errors of calls that were pending when the iframe ended, and of later calls; and the remaining observers. */
export async function endFrame(address: string, sandbox: string, how: string) {
  const { MutationObserver: Original } = globalThis;
  const observing = new Set<MutationObserver>();
  globalThis.MutationObserver = class extends Original {
    override observe(target: Node, options?: MutationObserverInit) {
      observing.add(this);
      super.observe(target, options);
    }
    override disconnect() {
      observing.delete(this);
      super.disconnect();
    }
  };
  try {
    const { frame: element, stage } = await connect(address, sandbox, undefined, how.includes('around'));
    const errors: string[] = [];
    stage.on('error', ({ message }) => errors.push(message));
    const reasonOf = (error: unknown) => (error instanceof SimulatorError ? error.message : String(error));
    const pending = [stage.seek(600), stage.seek(599)].map((call) => call.then(() => 'done', reasonOf));
    const before = observing.size;
    ENDINGS[how](element);
    const reasons = await Promise.all(pending);
    const later = await stage.stats().then(() => 'done', reasonOf);
    await stage.dispose();
    element.remove();
    return { reasons, later, errors, before, after: observing.size };
  } finally {
    globalThis.MutationObserver = Original;
  }
}

/** The error of a page that waits for an iframe and removes it. */
export async function removeWhileWaiting(address: string): Promise<string> {
  const element = frame(address);
  const connecting = connectFrame(element);
  element.remove();
  return connecting.then(
    () => 'connected',
    (error) => (error instanceof SimulatorError ? error.message : String(error)),
  );
}

/** Resolves when the frame's pictures have its size: an iframe gets its size with the frames of the parent page. */
export async function isSized({ frame: { width, height }, stage }: Framed): Promise<void> {
  const size = async () => {
    const picture = await createImageBitmap(await stage.picture());
    return [picture.width, picture.height].join();
  };
  while ((await size()) !== [width, height].join()) await new Promise(requestAnimationFrame);
}

/**
 * Whether an existing iframe accepts this page. @param timeout milliseconds without a response after which it does not
 */
export async function letsIn(address: string, timeout?: number): Promise<boolean> {
  const element = frame(address);
  await new Promise((resolve) => element.addEventListener('load', resolve));
  const signal = timeout === undefined ? undefined : AbortSignal.timeout(timeout);
  return connectFrame(element, { signal }).then(
    () => true,
    () => false,
  );
}

/** State that hostile messages could change. */
export async function stateOf(stage: RemoteStage) {
  const { steps, alive } = await stage.stats();
  return { hash: await stage.hash(), values: await stage.get(), steps, alive };
}

/**
 * Sends hostile messages to an iframe's window and to a separate port. @returns the number of responses without error
 */
export async function attack(element: HTMLIFrameElement, count: number): Promise<{ accepted: number; sent: number }> {
  const { port1, port2 } = new MessageChannel();
  const report = { accepted: 0, sent: 0 };
  const answered = new Map<number, () => void>();
  const answerTo = (id: number) => new Promise<void>((resolve) => answered.set(id, resolve));
  port1.onmessage = ({ data }: MessageEvent<{ id: number; error?: unknown }>) => {
    const isMeant = answered.get(data.id);
    if (isMeant) isMeant();
    else if (!data.error) report.accepted += 1;
  };
  const opened = answerTo(0);
  element.contentWindow!.postMessage({ cartoonSmoke: 'connect' }, '*', [port2]);
  await opened;
  for (const message of hostileMessages(count, 11)) {
    port1.postMessage(message);
    element.contentWindow!.postMessage(message, '*');
    report.sent += 1;
    // Yield to the frame, or all messages pile up in its queue.
    if (report.sent % 100 === 0) await new Promise((resolve) => setTimeout(resolve));
  }
  const last = answerTo(77);
  port1.postMessage({ id: 77, method: 'stats', args: [] });
  await last;
  return report;
}
