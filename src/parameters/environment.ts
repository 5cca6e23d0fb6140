/** Page settings in the URL query, as opposed to smoke parameters: `?paused=1&t=2.5&ui=0&stats=1&quality=0.75`. */
import { notice, type Notice } from './notice.ts';
import { DEBUG_VIEWS, LOWEST_QUALITY, type DebugView, type Quality } from './quality.ts';

export interface Environment {
  /** Whether to start paused. */
  readonly paused: boolean;
  /** Simulated seconds before the first frame, 0 to 600; undefined if the query has no `t`. */
  readonly time: number | undefined;
  /** Whether the panel, the playback controls and messages are shown. */
  readonly hasInterface: boolean;
  readonly hasStatistics: boolean;
  readonly quality: Quality;
  /** Debug view that replaces the image; undefined for the image. */
  readonly view: DebugView | undefined;
  readonly notices: readonly Notice[];
}

/** Maximum of `t`: simulated seconds before the first frame. */
export const LONGEST_LEAD = 600;

/** Parses a URL query, with or without `?`. Never throws; ignores unknown flags. */
export function readEnvironment(search: string): Environment {
  const query = new URLSearchParams(search);
  const notices: Notice[] = [];
  return {
    paused: isOn(query.get('paused'), false),
    time: readTime(query.get('t'), notices, 't'),
    hasInterface: isOn(query.get('ui'), true),
    hasStatistics: isOn(query.get('stats'), false),
    quality: readQuality(query.get('quality'), notices),
    view: readView(query.get('view'), notices),
    notices,
  };
}

/** `0` and `false` are off; any other value is on, including `?paused` without one. */
function isOn(text: string | null, fallback: boolean): boolean {
  return text === null ? fallback : text !== '0' && text !== 'false';
}

function readView(text: string | null, notices: Notice[]): DebugView | undefined {
  const view = DEBUG_VIEWS.find((name) => name === text);
  const sentence = (quoted: string) => `view cannot be ${quoted}: it takes ${DEBUG_VIEWS.join(', ')}.`;
  if (text !== null && !view) notices.push(notice('malformed', 'view', text, sentence));
  return view;
}

function readQuality(text: string | null, notices: Notice[]): Quality {
  if (text === null || text === 'auto') return 'auto';
  const given = readNumber(text);
  if (Number.isNaN(given)) {
    const sentence = (quoted: string) => `quality cannot be ${quoted}: it takes auto or a share such as 0.75.`;
    notices.push(notice('malformed', 'quality', text, sentence));
    return 'auto';
  }
  const quality = Math.min(Math.max(given, LOWEST_QUALITY), 1);
  const sentence = (quoted: string) => `quality cannot be ${quoted}; ${quality} is used (${LOWEST_QUALITY} to 1).`;
  if (quality !== given) notices.push(notice('outOfRange', 'quality', text, sentence));
  return quality;
}

/** Parses plain decimal notation; NaN for anything else. */
function readNumber(text: string): number {
  return /^[+-]?\d*\.?\d+$/.test(text) ? Number(text) : Number.NaN;
}

/**
 * Parses simulated seconds before the first frame, clamped to 0 to 600.
 * @param name of the flag or attribute, for notices
 */
export function readTime(text: string | null, notices: Notice[], name: string): number | undefined {
  if (text === null) return undefined;
  const given = readNumber(text);
  if (Number.isNaN(given)) {
    const sentence = (quoted: string) => `${name} cannot be ${quoted}: it takes seconds, such as 2.5.`;
    notices.push(notice('malformed', name, text, sentence));
    return undefined;
  }
  const time = Math.min(Math.max(given, 0), LONGEST_LEAD);
  const sentence = (quoted: string) => `${name} cannot be ${quoted}; ${time} s is used (0 to ${LONGEST_LEAD}).`;
  if (time !== given) notices.push(notice('outOfRange', name, text, sentence));
  return time;
}
