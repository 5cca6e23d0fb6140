import { STEP_SECONDS } from '../simulator/clock.ts';
import type { StageStats } from './contract.ts';
import type { Picture } from './picture.ts';
import type { Simulation } from './simulation.ts';

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
