/** What the query of an address asks of the page, not of the smoke: `?paused=1&t=2.5&ui=0&stats=1`. */
import { notice, type Notice } from './notice.ts';

export interface Environment {
  /** Start without playing. */
  readonly paused: boolean;
  /** Simulated seconds before the first picture, 0 to 600; undefined when the address does not say. */
  readonly time: number | undefined;
  /** Whether panel, transport and messages are shown. */
  readonly hasInterface: boolean;
  readonly hasStatistics: boolean;
  readonly notices: readonly Notice[];
}

/** The most simulated seconds that an address may ask for before the first picture. */
export const LONGEST_LEAD = 600;

/** Reads the query of an address, with or without `?`. Never throws; flags it does not know are not its business. */
export function readEnvironment(search: string): Environment {
  const query = new URLSearchParams(search);
  const notices: Notice[] = [];
  return {
    paused: isOn(query.get('paused'), false),
    time: readTime(query.get('t'), notices),
    hasInterface: isOn(query.get('ui'), true),
    hasStatistics: isOn(query.get('stats'), false),
    notices,
  };
}

/** `?paused`, `?paused=1` and `?paused=true` are on, `0` and `false` are off. */
function isOn(text: string | null, fallback: boolean): boolean {
  return text === null ? fallback : text !== '0' && text !== 'false';
}

function readTime(text: string | null, notices: Notice[]): number | undefined {
  if (text === null) return undefined;
  const given = /^[+-]?\d*\.?\d+$/.test(text) ? Number(text) : Number.NaN;
  if (Number.isNaN(given)) {
    notices.push(notice('malformed', 't', text, (quoted) => `t cannot be ${quoted}: it takes seconds, such as 2.5.`));
    return undefined;
  }
  const time = Math.min(Math.max(given, 0), LONGEST_LEAD);
  const tell = (quoted: string) => `t cannot be ${quoted}; ${time} s is used (0 to ${LONGEST_LEAD}).`;
  if (time !== given) notices.push(notice('outOfRange', 't', text, tell));
  return time;
}
