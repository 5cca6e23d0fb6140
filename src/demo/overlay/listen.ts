/** What starts the smoke of the overlay: keys, messages of other windows and local web sockets. */
import { keyOf } from '../../internal.ts';
import { isTrigger, isTriggerText, type Trigger } from './options.ts';

/** Milliseconds before a lost web socket is opened again: twice as long after each failure. */
const FIRST_WAIT_MS = 1000;
const LONGEST_WAIT_MS = 30_000;

/**
 * Waits for triggers.
 * @param start called for each of them
 * @param say called with sentences about the state of web sockets
 */
export function listen(triggers: readonly Trigger[], start: () => void, say: (sentence: string) => void): void {
  for (const trigger of triggers) {
    if (trigger.kind === 'key') listenToKey(trigger.name, start);
    else if (trigger.kind === 'message') addEventListener('message', ({ data }) => isTrigger(data) && start());
    else connect(trigger.address, start, say);
  }
}

/** @param name a character or the name of a key, such as `f9`, or its place on the keyboard, such as `numpad1` */
function listenToKey(name: string, start: () => void): void {
  addEventListener('keydown', (event) => {
    if (!event.repeat && [keyOf(event), event.code].some((each) => each.toLowerCase() === name)) start();
  });
}

/** Connects again whenever the connection ends, because the other program may start later than the page. */
function connect(address: string, start: () => void, say: (sentence: string) => void): void {
  let wait = FIRST_WAIT_MS;
  const open = () => {
    const socket = new WebSocket(address);
    socket.addEventListener('open', () => {
      wait = FIRST_WAIT_MS;
      say(`Connected to ${address}`);
    });
    socket.addEventListener('message', ({ data }) => isTriggerText(data) && start());
    socket.addEventListener('close', () => {
      say(`No connection to ${address}. The next attempt is in ${wait / 1000} s.`);
      setTimeout(open, wait);
      wait = Math.min(2 * wait, LONGEST_WAIT_MS);
    });
  };
  open();
}
