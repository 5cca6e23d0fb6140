import type { Stage, StageStats } from '../../index.ts';
import { create } from '../ui/dom.ts';
import { strings } from '../strings.ts';

const REFRESH_MS = 250;

export interface Statistics {
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
