/**
 * A message for the user about part of a link, URL or file that was ignored, changed or replaced. It is not an error.
 */
export interface Notice {
  readonly code:
    | 'unknownKey'
    | 'outOfRange'
    | 'malformed'
    | 'unknownPreset'
    | 'duplicate'
    | 'version'
    | 'otherVersion'
    | 'damaged'
    | 'tooLong'
    | 'more';
  /** Key that the notice concerns; empty if it concerns the whole link. */
  readonly key: string;
  /** The given text, truncated. It is untrusted: never insert it as HTML. */
  readonly given: string;
  /** One English sentence with the key, the given text and the replacement. */
  readonly message: string;
}

const LONGEST_GIVEN = 40;
const MAX_NOTICES = 8;

/** @param sentence builds the message from the given text, which is already quoted and truncated */
export function notice(code: Notice['code'], key: string, given: string, sentence: (given: string) => string): Notice {
  const short = shorten(given);
  return { code, key: shorten(key), given: short, message: sentence(`\u201c${short}\u201d`) };
}

/** Keeps the first notices and adds a count of the rest, so that a malicious link cannot flood the page. */
export function summarise(notices: readonly Notice[]): Notice[] {
  if (notices.length <= MAX_NOTICES) return [...notices];
  const rest = String(notices.length - MAX_NOTICES);
  const more = notice('more', '', rest, () => `The link has ${rest} more parts that could not be used.`);
  return [...notices.slice(0, MAX_NOTICES), more];
}

/** Quotes and truncates an untrusted key for a message. */
export function quoteKey(key: string): string {
  return `\u201c${shorten(key)}\u201d`;
}

function shorten(text: string): string {
  const visible = text.replace(/\p{C}/gu, ' ');
  return visible.length <= LONGEST_GIVEN ? visible : `${visible.slice(0, LONGEST_GIVEN - 1)}\u2026`;
}
