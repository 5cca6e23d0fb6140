import { STEP_SECONDS } from '../simulator/clock.ts';
import type { Picture } from './picture.ts';
import type { Simulation } from './simulation.ts';

/** Statistics of the latest frame. */
export interface StageStats {
  /** Simulated seconds. */
  time: number;
  steps: number;
  alive: number;
  /** Particles that cannot be emitted until others die. */
  waiting: number;
  /** Number of inputs since the take started, and whether they exceed what a take can record. */
  inputs: number;
  isTruncated: boolean;
  /** Bytes of the states saved for seeking backwards. */
  historyBytes: number;
  bodiesDrawn: number;
  castersDrawn: number;
  bodiesTotal: number;
  castersTotal: number;
  simMs: number;
  arrangeMs: number;
  renderMs: number;
  drawCalls: number;
  /**
   * False where the GPU does not store the depth that fragments write. Puffs are then flat and intersect in straight
   * lines.
   */
  writesDepth: boolean;
  /** Fraction of the pixel ratio that the latest frame was drawn with. */
  scale: number;
  /**
   * Milliseconds that the GPU took for a recent frame. Missing until it is measured (see `Stage.timeGpu`), and
   * where the browser lacks EXT_disjoint_timer_query_webgl2.
   */
  gpuMs?: number;
}

export interface StatsOptions {
  /** Whether to measure `gpuMs` in the frames until the next call. Default: false. */
  gpu?: boolean;
}

export function statsOf(
  { simulator, historyBytes, stepMs }: Simulation,
  { smoke, presenter, report, renderMs, scale, timer }: Picture,
): StageStats {
  const { renderer, writesDepth } = presenter.device;
  const { alive, waiting, steps, inputCount, isTruncated } = simulator;
  return {
    time: steps * STEP_SECONDS,
    steps,
    alive,
    waiting,
    inputs: inputCount,
    isTruncated,
    historyBytes,
    ...report,
    bodiesTotal: alive,
    castersTotal: smoke.style.shadows ? alive : 0,
    simMs: stepMs,
    renderMs,
    drawCalls: renderer.info.render.calls,
    writesDepth,
    scale,
    ...timer?.read(),
  };
}
