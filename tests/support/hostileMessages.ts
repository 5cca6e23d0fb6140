import { methodNames, methods } from '../../src/stage/remote/methods.ts';
import { random as seeded } from '../visual/random.ts';

const STRANGE = [
  undefined,
  null,
  NaN,
  Infinity,
  -1,
  1e308,
  '',
  '__proto__',
  'constructor',
  'toString',
  'x'.repeat(1e5),
];
const METHODS = [
  ...methodNames,
  'listen',
  'unlisten',
  'dispose',
  '__proto__',
  'constructor',
  'then',
  'hasOwnProperty',
  '',
];

/** Calls without arguments: with an empty argument list they would be valid. */
const NO_ARGUMENTS = new Set<string>(methodNames.filter((name) => methods[name].takes.length === 0));
const NO_LISTS = [7, 'args', { length: 1e9 }, { 0: 1, length: 1 }, null];
const WRONG_LISTS = [[NaN], ['x'.repeat(1e4)], [{ 'emission.rate': 'many' }], [[{}]], [-Infinity], [new Uint8Array(9)]];

/** Hostile messages with a wrong shape, size or value, some of them almost valid. */
export function* hostileMessages(count: number, seed: number): Generator {
  const random = seeded(seed);
  const pick = <Item>(items: readonly Item[]): Item => items[Math.floor(random() * items.length)];
  const junk = (depth = 0): unknown => {
    const kind = Math.floor(random() * (depth < 3 ? 7 : 5));
    if (kind < 2) return pick(STRANGE);
    if (kind === 2) return Math.floor((random() - 0.5) * 2 ** 32);
    if (kind === 3) return new Uint8Array(Math.floor(random() * 64)).map(() => random() * 256);
    if (kind === 4) return new Map([[pick(METHODS), 1]]);
    const inner = Array.from({ length: Math.floor(random() * 5) }, () => junk(depth + 1));
    return kind === 5 ? inner : Object.fromEntries(inner.map((each) => [pick(METHODS), each]));
  };
  const args = (method: string): unknown => {
    const needsNone = method === 'step' || !Object.hasOwn(methods, method) || NO_ARGUMENTS.has(method);
    return pick(needsNone ? NO_LISTS : [...NO_LISTS, ...WRONG_LISTS]);
  };
  for (let message = 0; message < count; ++message) {
    if (random() < 0.4) yield junk();
    else {
      const method = pick(METHODS);
      yield { id: pick([1, 2, 1e9, -1, 0.5, '1', null]), method, args: args(method), extra: junk() };
    }
  }
}
