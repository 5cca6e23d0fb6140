/** Random states for links. They consist of a few plain numbers, so that ten thousand take seconds and shrink well. */
import fc from 'fast-check';
import type { State } from '../../src/parameters/codec.ts';
import { MAX_STOPS, writeCurve } from '../../src/parameters/curve.ts';
import { MAX_POINTS, writePath } from '../../src/parameters/path.ts';
import type { NumberParameter, Parameter, Value, Values } from '../../src/parameters/parameter.ts';
import { presets, presetValues } from '../../src/parameters/presets.ts';
import { MAX_COLORS, writeRamp } from '../../src/parameters/ramp.ts';
import { table } from '../../src/parameters/table.ts';

/** Row index, and a number that determines its value. */
const anyChange = fc.tuple(fc.nat({ max: table.length - 1 }), fc.nat({ max: 999_999_999 }));

/** Mostly a few changes, sometimes so many that the link is packed. */
const anyChanges = fc.oneof(
  { arbitrary: fc.array(anyChange, { maxLength: 20 }), weight: 9 },
  { arbitrary: fc.array(anyChange, { minLength: 20, maxLength: 80 }), weight: 1 },
);

export const anyState: fc.Arbitrary<State> = fc
  .tuple(fc.constantFrom(...presets), anyChanges)
  .map(([preset, changes]) => {
    const values = changes.map(([row, share]) => [table[row].key, valueOf(table[row], share / 1e9)] as const);
    return { preset: preset.name, values: { ...presetValues(preset), ...(Object.fromEntries(values) as Values) } };
  });

/** @param share 0 to below 1. Every tenth number is an end of the range; the others are inside it with all digits. */
export function valueOf(parameter: Parameter, share: number): Value {
  switch (parameter.kind) {
    case 'toggle':
      return Math.floor(2 * share);
    case 'choice':
      return parameter.options[Math.floor(share * parameter.options.length)].value;
    case 'color':
      return `#${Math.floor(share * 0x1000000)
        .toString(16)
        .padStart(6, '0')}`;
    case 'curve':
      return writeCurve(places(share, 2, MAX_STOPS).map((at) => ({ at, value: (7 * at + share) % 1 })));
    case 'path': {
      const points = places(share, 2, MAX_POINTS);
      return share < 0.1 ? '' : writePath(points.map((at, index) => [198 * at - 99, 7 * share, -(at * index) % 60]));
    }
    case 'drawing':
      return share < 0.5 ? '' : 'ff8800*GRk-gg-Cg;ffffff*GRk-gg-Cg.G5uqggqWg,3355aa*Hh4qggqWg,*G5uqv';
    case 'outline':
      return share < 0.5 ? '' : 'GRkgg-CgA.G5uqggqWg;;Hh4qggqWg';
    case 'timeline':
      return share < 0.5 ? '' : `600*loop;emission.rate/0*60/120*${share}*e;burst/60*0*24`;
    case 'ramp':
      return share < 0.1 ? '' : writeRamp(places(share, 2, MAX_COLORS).map((at) => ({ at, color: gray(at) })));
    default:
      return numberIn(parameter, share);
  }
}

function numberIn({ kind, min, max, linkMax = max }: NumberParameter, share: number): number {
  if (share < 0.05) return min;
  if (share < 0.1) return linkMax;
  const number = min + (share - 0.1) * (10 / 9) * (linkMax - min);
  // Rounding can return -0, which a link writes as 0.
  return kind === 'integer' ? Math.round(number) + 0 : number;
}

/** Ascending positions, the first below 1, in multiples of 0.001. */
function places(share: number, min: number, max: number): number[] {
  const count = min + Math.floor(share * (max - min + 1));
  return Array.from({ length: count }, (_, index) => Math.floor((1000 * (index + share)) / count) / 1000);
}

function gray(share: number): string {
  return `#${Math.floor(255 * share)
    .toString(16)
    .padStart(2, '0')
    .repeat(3)}`;
}
