import { SimulatorError } from '../preset/errors.ts';
import type { RemoteStage } from '../remote/contract.ts';
import { isHandshake, handshake } from '../remote/handshake.ts';
import { packError } from '../remote/packedErrors.ts';
import { OPENING } from '../remote/protocol.ts';
import { serveStage } from '../remote/serveStage.ts';

/** A page that connects more often than that gets no answer any more. */
const MAX_CONNECTIONS = 16;

/**
 * Lets the page around this frame have the stage.
 * @param allowed the one origin that may, as `?origin=` says; undefined lets any, empty none
 * @param whenStanding asks for the smoke and is settled when its first picture stands
 */
export function answerPage(
  stage: RemoteStage,
  allowed: string | undefined,
  whenStanding: () => Promise<unknown>,
): void {
  if (window.parent === window || allowed === '') return;
  let connections = 0;
  const standing = new Set<MessagePort>();
  window.addEventListener('message', ({ source, origin, data, ports }) => {
    if (source !== window.parent || (allowed !== undefined && origin !== allowed)) return;
    if (!isHandshake(data, 'connect') || ports.length !== 1 || ++connections > MAX_CONNECTIONS) return;
    const [port] = ports;
    serveStage(port, stage);
    whenStanding().then(
      () => {
        port.postMessage({ id: OPENING });
        standing.add(port);
      },
      (error) => port.postMessage({ id: OPENING, error: packError(error) }),
    );
  });
  window.addEventListener('pagehide', ({ persisted }) => {
    // A page that goes into the browser's cache may come back.
    if (persisted) return;
    const error = packError(new SimulatorError('The frame was unloaded; connect again.'));
    for (const port of standing) port.postMessage({ id: OPENING, error });
  });
  window.parent.postMessage(handshake('here'), allowed ?? '*');
}

/** The origin that a query names, such as `?origin=https://example.org`; empty, for nobody, where it is no address. */
export function originOf(search: string): string | undefined {
  const given = new URLSearchParams(search).get('origin');
  if (given === null) return undefined;
  return URL.canParse(given) ? new URL(given).origin : '';
}
