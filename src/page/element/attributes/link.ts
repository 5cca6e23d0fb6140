/** Parsing of share links in `src` and of their `t` values. */
import { decode } from '../../../parameters/codec.ts';
import { readEnvironment, readTime } from '../../../parameters/environment.ts';
import { notice, type Notice } from '../../../parameters/notice.ts';
import type { Values } from '../../../parameters/parameter.ts';
import { defaultPreset } from '../../../parameters/presets.ts';

/** State that the parameter attributes of an element override. */
export interface Base {
  /** The share link, as in `src`. */
  readonly link: string | null;
  readonly values: Values;
  /** Simulated seconds before the first frame. */
  readonly start: number | undefined;
  /** Whether the link requests a paused frame. */
  readonly isPaused: boolean;
  /** Bytes of the take in a share link to one moment. */
  readonly take: Uint8Array | undefined;
}

/** Parses `src`. Never rejects; problems are added to `notices`. */
export async function readLink(link: string, base: string, notices: Notice[]): Promise<Base> {
  const { hash, search } = addressOf(link, base, notices);
  const { state, take, notices: ofHash } = await decode(hash);
  const { time, paused, notices: ofQuery } = readEnvironment(search);
  notices.push(...ofHash, ...ofQuery);
  return { link, values: state.values, start: time, isPaused: paused, take };
}

function addressOf(link: string, base: string, notices: Notice[]): Pick<URL, 'hash' | 'search'> {
  try {
    const address = new URL(link, base);
    if (address.hash === '') {
      const sentence = (given: string) =>
        `src cannot be ${given}: it takes a share link, such as #v=1&preset=wisp. \u201c${defaultPreset.name}\u201d is shown.`;
      notices.push(notice('malformed', 'src', link, sentence));
    }
    return address;
  } catch {
    notices.push(notice('damaged', 'src', link, (given) => `src cannot be ${given}: it takes a share link.`));
    return { hash: '', search: '' };
  }
}

/** Parses `start` with the syntax of a link's `t`. */
export function readStart(text: string, notices: Notice[]): number | undefined {
  return readTime(text, notices, 'start');
}
