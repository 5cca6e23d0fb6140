import { ParameterError, SimulatorError } from '../preset/errors.ts';
import type { RemoteStage } from './contract.ts';
import { isHandshake, handshake } from './handshake.ts';
import { PortStage } from './portStage.ts';

export interface ConnectOptions {
  /** Where the iframe has to be from; anywhere when left out, and always in a sandbox without `allow-same-origin`. */
  origin?: string;
  /** Aborting ends the waiting for an iframe that does not come. */
  signal?: AbortSignal;
}

/**
 * The stage in an iframe that shows `embed.html`, whatever site and sandbox it is in. Waits until its smoke stands, which
 * asks it to start. The size and what is in view are the iframe's own affair: `resize` and `setVisible` do nothing. Should
 * the iframe load anew, show another page or be removed, pending and later calls reject with a SimulatorError, its stage
 * has an error event, and can be connected to again.
 * @throws what createStage throws in the iframe; ParameterError for an origin that is none; the signal's reason when that
 * aborts; SimulatorError when the iframe is removed meanwhile
 */
export async function connectFrame(
  iframe: HTMLIFrameElement,
  { origin = '*', signal }: ConnectOptions = {},
): Promise<RemoteStage> {
  signal?.throwIfAborted();
  demandOrigin(origin);
  const hearing = new AbortController();
  const tries: PortStage[] = [];
  const connect = () => {
    const { port1, port2 } = new MessageChannel();
    tries.push(new PortStage(port1, 'frame', () => hearing.abort()));
    iframe.contentWindow?.postMessage(handshake('connect'), origin, [port2]);
    return tries.at(-1)!;
  };
  try {
    const stage = await firstOpened(iframe, connect, signal);
    for (const other of tries) if (other !== stage) other.abandon();
    const fail = (reason: string) => {
      hearing.abort();
      stage.fail(new SimulatorError(`The frame ${reason}; connect again.`));
    };
    whenHeard(iframe, hearing.signal, () => fail('was reloaded'));
    whenRemoved(iframe, hearing.signal, () => fail('was removed'));
    return stage.face;
  } catch (error) {
    for (const one of tries) one.abandon();
    hearing.abort();
    throw error;
  }
}

/** @throws ParameterError for what `postMessage` would not take, which would throw into the page's events later on */
function demandOrigin(origin: string): void {
  try {
    if (origin !== '*' && origin !== '/') new URL(origin);
  } catch {
    throw new ParameterError('origin', origin, "an address such as 'https://example.org', or '*'");
  }
}

/** Connects at once if there is anybody, and again when the iframe says that it is there. */
function firstOpened(
  iframe: HTMLIFrameElement,
  connect: () => PortStage,
  signal: AbortSignal | undefined,
): Promise<PortStage> {
  return new Promise((resolve, reject) => {
    const heard = new AbortController();
    const settle = (act: () => void) => {
      heard.abort();
      act();
    };
    const wait = () => {
      const stage = connect();
      stage.opened.then(
        () => settle(() => resolve(stage)),
        (error) => settle(() => reject(error)),
      );
    };
    signal?.addEventListener('abort', () => settle(() => reject(signal.reason)), { signal: heard.signal });
    whenHeard(iframe, heard.signal, wait);
    whenRemoved(iframe, heard.signal, () => settle(() => reject(new SimulatorError('The frame was removed.'))));
    if (!isEmpty(iframe)) wait();
  });
}

/** Whether its page is still on its way: nobody receives the handshake, and the console would tell of the origin that it has not. */
function isEmpty({ contentDocument }: HTMLIFrameElement): boolean {
  return contentDocument?.URL === 'about:blank';
}

/** Calls back whenever the page in an iframe says that it is there. */
function whenHeard(iframe: HTMLIFrameElement, signal: AbortSignal, act: () => void): void {
  const listen = ({ source, data }: MessageEvent) => {
    if (source === iframe.contentWindow && isHandshake(data, 'here')) act();
  };
  window.addEventListener('message', listen, { signal });
}

/**
 * Calls back once an iframe that was in the document is taken from it or moved, which ends the page in it. Ports do not tell of that
 * in all browsers.
 */
function whenRemoved(iframe: HTMLIFrameElement, signal: AbortSignal, act: () => void): void {
  let inside = iframe.contentWindow;
  const observer = new MutationObserver(() => {
    if (inside && inside !== iframe.contentWindow) act();
    inside = iframe.contentWindow;
  });
  for (const root of rootsAround(iframe)) observer.observe(root, { childList: true, subtree: true });
  signal.addEventListener('abort', () => observer.disconnect());
}

/** The document and each shadow root around an iframe: who observes one does not see into the others. */
function rootsAround(iframe: HTMLIFrameElement): Node[] {
  const roots: Node[] = [iframe.ownerDocument];
  for (let root = iframe.getRootNode(); root instanceof ShadowRoot; root = root.host.getRootNode()) roots.push(root);
  return roots;
}
