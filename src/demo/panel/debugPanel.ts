import type { DebugView, Stage } from '../../index.ts';
import { DEBUG_VIEWS } from '../../internal.ts';
import { create, uniqueId } from '../ui/dom.ts';
import type { Statistics } from './statistics.ts';
import { strings } from '../strings.ts';

/** Debug panel: statistics and the intermediate textures of the passes, for users without a keyboard. */
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

/** Legend of the debug view: its name and how to read it. */
export class Views {
  readonly element = create('p', { class: 'legend card', role: 'status' });
  private readonly stage: Stage;

  constructor(stage: Stage) {
    this.stage = stage;
    stage.on('statechange', () => this.notify());
    this.notify();
  }

  /** Shows the next debug view; after the last one the normal frame. */
  next(): void {
    const order: readonly (DebugView | undefined)[] = [undefined, ...DEBUG_VIEWS];
    this.stage.view = order[(order.indexOf(this.stage.view) + 1) % order.length];
  }

  private notify(): void {
    const { view } = this.stage;
    this.element.textContent = view ? strings.views[view] : '';
    this.element.hidden = !view;
  }
}
