/** The handshake between a page and the stage in an iframe, before they share a MessagePort. */
import { isPlain } from './shapes.ts';

/** 'here': the iframe announces itself. 'connect': the page requests the stage and transfers a port. */
export type HandshakeStep = 'here' | 'connect';

export function handshake(step: HandshakeStep): { cartoonSmoke: HandshakeStep } {
  return { cartoonSmoke: step };
}

export function isHandshake(message: unknown, step: HandshakeStep): boolean {
  return isPlain(message) && message.cartoonSmoke === step && Object.keys(message).length === 1;
}
