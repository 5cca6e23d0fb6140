import type { CartoonSmokeElement } from '../element/cartoonSmokeElement.ts';
import { HANDED_ON } from '../element/methods.ts';
import { SimulatorError } from '../../base/errors.ts';
import type { RemoteStage } from '../../stage/remote/contract.ts';
import { isHandshake, handshake, OPENING } from '../../stage/remote/protocol.ts';
import { makeMethods } from '../../stage/remote/makeMethods.ts';
import { packError } from '../../stage/remote/packedErrors.ts';
import { serveStage } from '../../stage/remote/serveStage.ts';

/** Connections after this many get no answer. */
const MAX_CONNECTIONS = 16;

/**
 * Serves the stage to the page that embeds this frame.
 * @param allowed origin that may connect, from `?origin=`; undefined allows any origin, an empty string none
 * @param start starts the smoke and resolves with its first frame
 */
export function answerPage(stage: RemoteStage, allowed: string | undefined, start: () => Promise<unknown>): void {
  if (window.parent === window || allowed === '') return;
  let connections = 0;
  const connected = new Set<MessagePort>();
  window.addEventListener('message', ({ source, origin, data, ports }) => {
    if (source !== window.parent || (allowed !== undefined && origin !== allowed)) return;
    if (!isHandshake(data, 'connect') || ports.length !== 1 || ++connections > MAX_CONNECTIONS) return;
    const [port] = ports;
    serveStage(port, stage);
    start().then(
      () => {
        port.postMessage({ id: OPENING });
        connected.add(port);
      },
      (error) => port.postMessage({ id: OPENING, error: packError(error) }),
    );
  });
  window.addEventListener('pagehide', ({ persisted }) => {
    // A page in the back/forward cache can be restored.
    if (persisted) return;
    const error = packError(new SimulatorError('The frame was unloaded; connect again.'));
    for (const port of connected) port.postMessage({ id: OPENING, error });
  });
  window.parent.postMessage(handshake('here'), allowed ?? '*');
}

/** Adapts an element to the RemoteStage interface. The element handles its size and visibility itself. */
export function elementStage(element: CartoonSmokeElement): RemoteStage {
  return {
    ...makeMethods(HANDED_ON, async (name, args) => {
      // A disconnected element would wait until it is inserted again.
      if (!element.isConnected) throw new SimulatorError('This stage was disposed; connect again.');
      return (element[name] as (...args: unknown[]) => Promise<unknown>)(...args);
    }),
    play: async () => element.play(),
    pause: async () => element.pause(),
    setBackground: async (isShown) => void (element.transparent = !isShown),
    resize: async () => {},
    setVisible: async () => {},
    ready: element.ready,
    thread: 'frame',
    on(event, listener) {
      let end = () => {};
      // A restart after a lost context has another stage.
      const attach = async () => {
        const stage = await element.stage;
        end();
        end = stage.on(event, listener);
      };
      attach().catch(() => undefined);
      element.addEventListener('ready', attach);
      return () => {
        element.removeEventListener('ready', attach);
        end();
      };
    },
    dispose: async () => element.remove(),
  };
}

/**
 * Reads the allowed origin from a query such as `?origin=https://example.org`. An invalid URL gives an empty string,
 * which allows no origin.
 */
export function originOf(search: string): string | undefined {
  const given = new URLSearchParams(search).get('origin');
  if (given === null) return undefined;
  try {
    return new URL(given).origin;
  } catch {
    return '';
  }
}
