/** What the panel says of the simulator's lists. The simulator generates lists.json, as the one in the parent folder. */
import { endsOf, LIST_LIMIT, listNames, lists, type Field } from '../lists.ts';
import type { Parameter } from '../parameter.ts';
import source from './lists.json' with { type: 'json' };
import type { AnyWords } from './words.ts';

interface FieldWords {
  readonly label: string;
  readonly text: string;
  /** Initial value of a newly added item, if it differs from the default. */
  readonly start?: number;
}

const words: Readonly<
  Record<string, { readonly label: string; readonly fields: Readonly<Record<string, FieldWords>> }>
> = source;

/** What the panel says of the colours and the ink of a look, which the simulator does not read. */
const lookWords: Readonly<Record<string, FieldWords>> = {
  'look.colors': {
    label: 'Own tones',
    text: 'Colours of its smoke from shadow to full light, instead of those of the smoke.',
  },
  'look.ageColors': {
    label: 'Own colours by age',
    text: 'Colours of its smoke over the life of a puff, instead of those of the smoke.',
  },
  'look.heatColors': {
    label: 'Own colours by heat',
    text: 'Colours of its smoke from temperature 0 to 1, instead of those of the smoke.',
  },
  'look.inkWeight': { label: 'Ink weight', text: 'Factor on the width of the lines of its smoke.' },
};

/** Label of an item, such as 'Vortex 2' for the second vortex. */
export function itemLabel(list: string, index: number): string {
  return `${words[list].label} ${index + 1}`;
}

/** Singular label of a list, such as 'Vortex'. */
export function listLabel(list: string): string {
  return words[list].label;
}

/** One group of the panel per possible list item. The panel shows it once the item is added. */
export const itemGroups: readonly { readonly key: string; readonly list: string; readonly label: string }[] =
  listNames.flatMap((list) =>
    Array.from({ length: LIST_LIMIT }, (_, index) => ({
      key: `${list}.${index}`,
      list,
      label: itemLabel(list, index),
    })),
  );

/** Whether a field is the outline of a shape. */
function isOutline({ default: { length } }: Field): boolean {
  return length === 0;
}

/** The outline of a newly added shape: a heart. */
const FIRST_OUTLINE = 'IBKiYqM3Owewd_uz8gxgxXxWxB-QuQuJ4WyeneZWOJIQSQSBCXPWPgPgPzE_Swjwi3yq0';

/** Values by flat key that create item `index` of a list with a visible effect. */
export function startValues(list: string, index: number): Record<string, number | string> {
  const startOf = (key: string) => words[list].fields[key].start;
  const starting = lists[list].filter((field) => startOf(field.key) !== undefined || isOutline(field));
  const chosen = starting.length > 0 ? starting : lists[list].filter((field) => field.names.length === 0).slice(0, 1);
  return Object.fromEntries(
    chosen.map((field) => [
      `${list}.${index}.${field.key}${endsOf(field)[0]}`,
      startOf(field.key) ?? field.default[0] ?? FIRST_OUTLINE,
    ]),
  );
}

/**
 * The words of a parameter of an item, such as `vortices.0.axis.x`; undefined for other keys. Large ranges have a few
 * hundred steps, and fine ones near zero, where most values are.
 */
export function itemWords(row: Parameter): AnyWords | undefined {
  const [, list, index, field, axis] = /^(\w+)\.(\d)\.(.+?)(?:\.([xyz]))?$/.exec(row.key) ?? [];
  if (!list) return undefined;
  const { label, text } = words[list].fields[field] ?? lookWords[field];
  const shown = { group: `${list}.${index}`, label: axis ? `${label} ${axis}` : label, text };
  if (row.kind === 'integer') return { ...shown, step: 1 };
  if (row.kind !== 'number') return shown;
  return row.max - row.min > 5 ? { ...shown, step: 0.05, slider: 'fine' } : { ...shown, step: 0.01 };
}
