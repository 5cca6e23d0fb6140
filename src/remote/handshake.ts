/** The handshake between a page and the smoke in one of its iframes, before they have a port of their own. */
import { isPlain } from './shapes.ts';

/** The iframe says that it is there; the page, with a port, that it wants the stage. */
export type HandshakeStep = 'here' | 'connect';

export function handshake(step: HandshakeStep): { cartoonSmoke: HandshakeStep } {
  return { cartoonSmoke: step };
}

export function isHandshake(message: unknown, step: HandshakeStep): boolean {
  return isPlain(message) && message.cartoonSmoke === step && Object.keys(message).length === 1;
}
