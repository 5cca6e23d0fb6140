import type { DebugView, Stage, StageStats } from '../../index.ts';
import { DEBUG_VIEWS } from '../../internal.ts';
import { create, uniqueId } from '../ui/dom.ts';
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

const REFRESH_MS = 250;

interface Statistics {
  readonly element: HTMLElement;
  /** Shows or hides the statistics; without an argument, toggles them. */
  toggle(isShown?: boolean): void;
  /** Calls back at once and after each change. */
  onToggle(listener: (isShown: boolean) => void): void;
}

/** Statistics of the stage, for `?stats=1` and on demand. */
export function createStatistics(stage: Stage): Statistics {
  const output = create('pre', { class: 'statistics', role: 'region', hidden: true });
  output.setAttribute('aria-label', strings.statistics.title);
  const listeners: ((isShown: boolean) => void)[] = [];
  let last = Number.NEGATIVE_INFINITY;
  let frames = 0;
  stage.on('frame', (stats) => {
    if (output.hidden) return;
    frames += 1;
    const elapsed = performance.now() - last;
    if (elapsed < REFRESH_MS) return;
    output.textContent = describe(stats, (1000 * frames) / elapsed);
    last = performance.now();
    frames = 0;
  });
  return {
    element: output,
    toggle(isShown = output.hidden !== false) {
      output.hidden = !isShown;
      stage.timeGpu(isShown);
      // A paused stage emits no frame event.
      output.textContent = describe(stage.stats, 0);
      for (const listener of listeners) listener(isShown);
    },
    onToggle(listener) {
      listeners.push(listener);
      listener(!output.hidden);
    },
  };
}

function describe(stats: StageStats, framesPerSecond: number): string {
  const milliseconds = (value: number) => `${value.toFixed(1)} ms`;
  return [
    `${framesPerSecond.toFixed(0)} frames/s   ${stats.drawCalls} draw calls   scale ${stats.scale}`,
    `${stats.time.toFixed(2)} s, step ${stats.steps}`,
    `${stats.alive} alive, ${stats.waiting} waiting`,
    `bodies  ${stats.bodiesDrawn} of ${stats.bodiesTotal}`,
    `casters ${stats.castersDrawn} of ${stats.castersTotal}`,
    `step ${milliseconds(stats.simMs)}, arrange ${milliseconds(stats.arrangeMs)}, draw ${milliseconds(stats.renderMs)}`,
    ...(stats.gpuMs === undefined ? [] : [`GPU ${milliseconds(stats.gpuMs)}`]),
  ].join('\n');
}
