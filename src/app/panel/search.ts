import type { Parameter } from '../../preset.ts';
import { create, uniqueId } from '../ui/dom.ts';
import type { Row } from './row.ts';
import { strings } from '../strings.ts';

type ParameterRows = Iterable<readonly [Parameter, Row]>;

/**
 * Search field that filters the panel by labels, descriptions, keys and group names. Matching groups open.
 * @param all returns the current rows, which change with the items
 * @param panel contains the groups
 */
export function createSearch(all: () => ParameterRows, panel: HTMLElement): HTMLElement {
  const id = uniqueId();
  const field = create('input', { id, type: 'search', class: 'search-field', placeholder: strings.panel.search });
  field.setAttribute('aria-label', strings.panel.search);
  const found = create('p', { role: 'status', class: 'search-found' });
  let wereOpen: ReadonlySet<Element> | undefined;
  const filter = () => {
    const words = wordsOf(field.value);
    const groups = [...panel.querySelectorAll<HTMLDetailsElement>('details.group:not([hidden])')];
    const rows = all();
    wereOpen ??= new Set(groups.filter(({ open }) => open));
    const count = words.length > 0 ? showOnly(words, rows, groups) : showAll(rows, groups, wereOpen);
    if (words.length === 0) wereOpen = undefined;
    found.textContent = count === undefined ? '' : strings.panel.found(count);
  };
  field.addEventListener('input', filter);
  return create('div', { class: 'search', role: 'search' }, field, found);
}

function showOnly(words: readonly string[], rows: ParameterRows, groups: readonly HTMLDetailsElement[]): number {
  const titles = new Map(groups.map((group) => [group, group.querySelector('summary')!.textContent]));
  for (const [{ key, label, text }, { element }] of rows) {
    const title = titles.get(element.closest('details')!) ?? '';
    element.classList.toggle('is-filtered', !speaksOf(words, `${label} ${text} ${key} ${title}`));
  }
  let count = 0;
  for (const group of groups) {
    const shown = group.querySelectorAll('.row:not(.is-filtered)').length;
    const isNamed = speaksOf(words, titles.get(group)!);
    group.classList.toggle('is-filtered', shown === 0 && !isNamed);
    group.open = group.open || shown > 0;
    count += shown;
  }
  return count;
}

function showAll(
  rows: ParameterRows,
  groups: readonly HTMLDetailsElement[],
  wereOpen: ReadonlySet<Element>,
): undefined {
  for (const [, { element }] of rows) element.classList.remove('is-filtered');
  for (const group of groups) {
    group.classList.remove('is-filtered');
    group.open = wereOpen.has(group);
  }
}

function wordsOf(text: string): readonly string[] {
  return text.toLowerCase().split(/\s+/).filter(Boolean);
}

function speaksOf(words: readonly string[], text: string): boolean {
  const lower = text.toLowerCase();
  return words.every((word) => lower.includes(word));
}
