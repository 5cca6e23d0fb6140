/** Something in a link or an address that was not taken as it stood: people are told, nothing throws. */
export interface Notice {
  readonly code:
    | 'unknownKey'
    | 'outOfRange'
    | 'malformed'
    | 'unknownPreset'
    | 'duplicate'
    | 'version'
    | 'otherVersion'
    | 'migrated'
    | 'damaged'
    | 'tooLong'
    | 'more';
  /** The key it is about; empty when it is about the link as a whole. */
  readonly key: string;
  /** The text that was given, shortened; it is untrusted and never to be used as HTML. */
  readonly given: string;
  /** One English sentence that names the key, what was given and what is used instead. */
  readonly message: string;
}

const LONGEST_GIVEN = 40;
const MAX_NOTICES = 8;

/** @param notify makes the sentence out of what was given, already quoted and shortened */
export function notice(code: Notice['code'], key: string, given: string, sentence: (given: string) => string): Notice {
  const short = shorten(given);
  return { code, key: shorten(key), given: short, message: sentence(`\u201c${short}\u201d`) };
}

/** Keeps the first few notices and says how many more there were, so that a hostile link cannot flood the page. */
export function summarise(notices: readonly Notice[]): Notice[] {
  if (notices.length <= MAX_NOTICES) return [...notices];
  const rest = String(notices.length - MAX_NOTICES);
  const more = notice('more', '', rest, () => `The link has ${rest} more parts that could not be used.`);
  return [...notices.slice(0, MAX_NOTICES), more];
}

/** Quotes an untrusted key for a sentence. */
export function quoteKey(key: string): string {
  return `\u201c${shorten(key)}\u201d`;
}

function shorten(text: string): string {
  const visible = text.replace(/\p{C}/gu, ' ');
  return visible.length <= LONGEST_GIVEN ? visible : `${visible.slice(0, LONGEST_GIVEN - 1)}\u2026`;
}
