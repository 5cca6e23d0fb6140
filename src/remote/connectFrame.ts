import { ParameterError, SimulatorError } from '../preset/errors.ts';
import type { RemoteStage } from './contract.ts';
import { isWord, say } from './knock.ts';
import { PortStage } from './portStage.ts';

export interface ConnectOptions {
  /** Where the frame has to be from; anywhere when left out, and always in a sandbox without `allow-same-origin`. */
  origin?: string;
  /** Aborting ends the waiting for a frame that does not come. */
  signal?: AbortSignal;
}

/**
 * The stage in a frame that shows `embed.html`, whatever site and sandbox it is in. Waits until its smoke stands, which asks
 * it to start. The size and what is in view are the frame's own affair: `resize` and `setVisible` do nothing. Should
 * the frame load anew, its stage has an error event, and can be connected to again.
 * @throws what createStage throws in the frame; ParameterError for an origin that is none; the signal's reason when that aborts
 */
export async function connectFrame(
  frame: HTMLIFrameElement,
  { origin = '*', signal }: ConnectOptions = {},
): Promise<RemoteStage> {
  signal?.throwIfAborted();
  demandOrigin(origin);
  const hearing = new AbortController();
  const tries: PortStage[] = [];
  const knock = () => {
    const { port1, port2 } = new MessageChannel();
    tries.push(new PortStage(port1, 'frame', () => hearing.abort()));
    frame.contentWindow?.postMessage(say('connect'), origin, [port2]);
    return tries.at(-1)!;
  };
  try {
    const stage = await firstOpened(frame, knock, signal);
    for (const other of tries) if (other !== stage) other.abandon();
    whenHeard(frame, hearing.signal, () => stage.fail(new SimulatorError('The frame was loaded anew; connect again.')));
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

/** Knocks at once if there is anybody, and again when the frame says that it is there. */
function firstOpened(
  frame: HTMLIFrameElement,
  knock: () => PortStage,
  signal: AbortSignal | undefined,
): Promise<PortStage> {
  return new Promise((resolve, reject) => {
    const heard = new AbortController();
    const settle = (act: () => void) => {
      heard.abort();
      act();
    };
    const wait = () => {
      const stage = knock();
      stage.opened.then(
        () => settle(() => resolve(stage)),
        (error) => settle(() => reject(error)),
      );
    };
    signal?.addEventListener('abort', () => settle(() => reject(signal.reason)), { signal: heard.signal });
    whenHeard(frame, heard.signal, wait);
    if (!isEmpty(frame)) wait();
  });
}

/** Whether its page is still on its way: nobody hears a knock, and the console would tell of the origin that it has not. */
function isEmpty({ contentDocument }: HTMLIFrameElement): boolean {
  return contentDocument?.URL === 'about:blank';
}

/** Calls back whenever the page in a frame says that it is there. */
function whenHeard(frame: HTMLIFrameElement, signal: AbortSignal, act: () => void): void {
  const listen = ({ source, data }: MessageEvent) => {
    if (source === frame.contentWindow && isWord(data, 'here')) act();
  };
  window.addEventListener('message', listen, { signal });
}
