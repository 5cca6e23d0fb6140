/** Migrates links of older versions to the current version. */
import { MAX_STOPS, writeCurve } from './curve.ts';
import { notice, type Notice } from './notice.ts';
import type { Values } from './parameter.ts';
import { fetched } from './timeout.ts';

/** Current version of the link format. */
export const VERSION = '3';

/** Version of a link that does not name one. */
const UNNAMED = '1';

/** Keys and values of a link, as text. */
type Pairs = ReadonlyMap<string, string>;

/** Versions that are still read. From 1 on only values of presets changed: {@link olderValues}. */
const OLDER = ['0', '1', '2'];

/** The version of a link or a file; an empty link has the current one. */
export function versionOf(pairs: Pairs): string {
  return pairs.get('v') ?? (pairs.size > 0 ? UNNAMED : VERSION);
}

/**
 * Values of a preset in links of a version, where they differ from the current ones.
 * @param preset name of an existing preset
 * @throws LoadError if the download fails or times out
 */
export async function olderValues(version: string, preset: string): Promise<Values> {
  if (!OLDER.includes(version)) return {};
  const { valuesOfVersion } = await fetched('Older link', import('./olderValues.ts'));
  return valuesOfVersion(version, preset);
}

/** Migrates the pairs of a link to the current version and adds notices. Unknown versions are left unchanged. */
export function migrate(pairs: Pairs, notices: Notice[]): Pairs {
  const version = versionOf(pairs);
  if (!OLDER.includes(version)) return pairs;
  return new Map([...(version === '0' ? gatherDensity(pairs, notices) : pairs), ['v', VERSION]]);
}

const DENSITY = /^density\.([0-7])\.(age|value)$/;

/**
 * Version 0 stored density over life as a list of stops, `density.0.age=.5&density.0.value=1`. Version 1 has a curve.
 */
function gatherDensity(pairs: Pairs, notices: Notice[]): Pairs {
  const rest = new Map([...pairs].filter(([key]) => !DENSITY.test(key)));
  if (rest.size === pairs.size) return pairs;
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
  const sentence = 'This is an old link: its density stops became the curve emission.density.';
  notices.push(notice('migrated', 'v', '0', () => sentence));
  return rest;
}

/** Removes duplicate positions and ensures at least two stops. */
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
