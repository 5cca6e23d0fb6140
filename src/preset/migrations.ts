/**
 * Links that people keep outlive the page that wrote them: what older versions wrote is turned into what this one reads,
 * one version after the other.
 */
import { MAX_STOPS, writeCurve } from './curve.ts';
import { notice, type Notice } from './notice.ts';

/** The version of links that this page writes. */
export const VERSION = '1';

/** Pairs of a link by their keys, all as text. */
type Pairs = ReadonlyMap<string, string>;

interface Migration {
  /** The version that it reads, and the one that it makes of it. */
  readonly from: string;
  readonly to: string;
  /** What became of what, as the sentence of a notice; undefined where this link had nothing of it. */
  readonly bring: (pairs: Pairs) => { pairs: Pairs; notified: string | undefined };
}

/** In the order of their versions. */
const migrations: readonly Migration[] = [{ from: '0', to: '1', bring: gatherDensity }];

/** Brings the pairs of a link up to this page's version, and tells what was changed. Versions that nobody wrote stay. */
export function migrate(pairs: Pairs, notices: Notice[]): Pairs {
  let current = pairs;
  for (const { from, to, bring } of migrations) {
    if (current.get('v') !== from) continue;
    const { pairs: next, notified } = bring(current);
    current = new Map([...next, ['v', to]]);
    if (notified !== undefined) notices.push(notice('migrated', 'v', from, () => notified));
  }
  return current;
}

const DENSITY = /^density\.([0-7])\.(age|value)$/;

/** Version 0 had the density over life as a list of stops, `density.0.age=.5&density.0.value=1`; now it is one curve. */
function gatherDensity(pairs: Pairs): { pairs: Pairs; notified: string | undefined } {
  const rest = new Map([...pairs].filter(([key]) => !DENSITY.test(key)));
  if (rest.size === pairs.size) return { pairs, notified: undefined };
  const share = (index: number, name: string, other: number) => {
    const number = Number(pairs.get(`density.${index}.${name}`) ?? other);
    return Math.min(Math.max(Number.isNaN(number) ? other : number, 0), 1);
  };
  const isGiven = (index: number) => pairs.has(`density.${index}.age`) || pairs.has(`density.${index}.value`);
  const stops = Array.from({ length: MAX_STOPS }, (_, index) => index)
    .filter(isGiven)
    .map((index) => ({ at: share(index, 'age', 0), value: share(index, 'value', 1) }))
    .toSorted((a, b) => a.at - b.at);
  rest.set('emission.density', writeCurve(completed(stops)));
  return { pairs: rest, notified: 'This is an old link: its density stops became the curve emission.density.' };
}

/** Each place once, and at least two of them. */
function completed(stops: readonly { at: number; value: number }[]): { at: number; value: number }[] {
  const rising = stops.filter(({ at }, index) => index === 0 || at > stops[index - 1].at);
  if (rising.length > 1) return rising;
  const [{ at, value }] = rising;
  return at < 1
    ? [
        { at, value },
        { at: 1, value },
      ]
    : [
        { at: 0, value },
        { at, value },
      ];
}
