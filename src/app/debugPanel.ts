import { DEBUG_VIEWS, type DebugView } from '../preset/quality.ts';
import type { Stage } from '../stage/stage.ts';
import { create, uniqueId } from './dom.ts';
import type { Statistics } from './statistics.ts';
import { strings } from './strings.ts';

/** What lies behind the picture, for people without keys: statistics, and what the passes work with. */
export function createDebugPanel(stage: Stage, statistics: Statistics): HTMLElement {
  const { title, view, picture, names } = strings.debugPanel;
  const options = DEBUG_VIEWS.map((name) => create('option', { value: name }, names[name]));
  const select = create('select', { id: uniqueId() }, create('option', { value: '' }, picture), ...options);
  select.addEventListener('change', () => (stage.view = (select.value || undefined) as DebugView | undefined));
  const show = () => (select.value = stage.view ?? '');
  stage.on('statechange', show);
  show();
  const figures = create('input', { id: uniqueId(), type: 'checkbox', role: 'switch' });
  figures.addEventListener('change', () => statistics.toggle(figures.checked));
  statistics.onToggle((isShown) => (figures.checked = isShown));
  return create(
    'details',
    { class: 'group' },
    create('summary', {}, title),
    row(view, select),
    row(strings.statistics.title, figures),
  );
}

function row(label: string, control: HTMLElement): HTMLElement {
  return create('div', { class: 'debug-panel-row' }, create('label', { for: control.id }, label), control);
}
