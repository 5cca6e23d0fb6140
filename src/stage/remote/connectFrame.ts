import { ParameterError, requireOptions, SimulatorError } from '../../base/errors.ts';
import { afterRunning } from '../../base/timeout.ts';
import type { RemoteStage } from './contract.ts';
import { isHandshake, handshake } from './protocol.ts';
import { PortStage } from './portStage.ts';

/** Time in which a stage responds after a load event of its iframe. A machine that draws on the CPU may be slow. */
const RESPONSE_MS = 10_000;

export interface ConnectOptions {
  /** Required origin of the iframe. Default: any. Omit it for a sandbox without `allow-same-origin`. */
  origin?: string;
  /** Aborts waiting for the iframe. */
  signal?: AbortSignal;
}

/**
 * Connects to the stage in an iframe that shows `embed.html`, on any site and in any sandbox. Makes it load its smoke,
 * and waits until the first picture is drawn. The iframe tracks its own size and visibility: `resize` and `setVisible`
 * do nothing. If the iframe reloads, navigates or is removed, pending and later calls reject with a SimulatorError, the
 * stage emits an error event, and the page can connect again.
 * @throws the errors of createStage in the iframe; ParameterError for an invalid origin; the signal's reason when it
 * aborts; SimulatorError when the iframe is removed before it answers
 */
export async function connectFrame(iframe: HTMLIFrameElement, options: ConnectOptions = {}): Promise<RemoteStage> {
  if ((iframe as HTMLIFrameElement | undefined)?.localName !== 'iframe')
    throw new ParameterError('iframe', iframe, 'an iframe element');
  requireOptions('connectFrame', options, ['origin', 'signal']);
  const { origin = '*', signal } = options;
  signal?.throwIfAborted();
  requireOrigin(origin);
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
    whenReplaced(iframe, hearing.signal, stage.stage, () => fail('was unloaded'));
    return stage.stage;
  } catch (error) {
    for (const one of tries) one.abandon();
    hearing.abort();
    throw error;
  }
}

/**
 * Checks the origin early: `postMessage` would throw later, in an event listener of the page.
 * @throws ParameterError for an origin that `postMessage` rejects
 */
function requireOrigin(origin: string): void {
  try {
    if (origin !== '*' && origin !== '/') new URL(origin);
  } catch {
    throw new ParameterError('origin', origin, "an address such as 'https://example.org', or '*'");
  }
}

/** Connects at once unless the iframe is empty, and again whenever it announces itself. */
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

/**
 * Whether the iframe's page is not loaded yet: a message would be lost, and the browser would log an origin mismatch.
 */
function isEmpty({ contentDocument }: HTMLIFrameElement): boolean {
  return contentDocument?.URL === 'about:blank';
}

/** Calls back whenever the page in the iframe announces itself. */
function whenHeard(iframe: HTMLIFrameElement, signal: AbortSignal, act: () => void): void {
  const listen = ({ source, data }: MessageEvent) => {
    if (source === iframe.contentWindow && isHandshake(data, 'here')) act();
  };
  window.addEventListener('message', listen, { signal });
}

/**
 * Calls back when the iframe is removed from the document or moved, which unloads its page. Not all browsers report
 * this on the message port.
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

/**
 * Calls back when another page is loaded in the iframe and the stage no longer responds. A page that is busy when it
 * navigates ends without the pagehide event in which it reports its end.
 */
function whenReplaced(iframe: HTMLIFrameElement, signal: AbortSignal, stage: RemoteStage, act: () => void): void {
  const check = () => {
    const end = afterRunning(RESPONSE_MS, act);
    signal.addEventListener('abort', end);
    // The load event of the stage's own page can come after the stage is open.
    stage.stats().then(end, end);
  };
  iframe.addEventListener('load', check, { signal });
}

/** The document and each shadow root around the iframe: a MutationObserver does not see into shadow roots. */
function rootsAround(iframe: HTMLIFrameElement): Node[] {
  const roots: Node[] = [iframe.ownerDocument];
  for (let root = iframe.getRootNode(); 'host' in root; root = (root as ShadowRoot).host.getRootNode())
    roots.push(root);
  return roots;
}
