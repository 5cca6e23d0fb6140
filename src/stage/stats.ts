import { STEP_SECONDS } from '../sim/clock.ts';
import type { StageStats } from './contract.ts';
import type { Picture } from './picture.ts';
import type { Simulation } from './simulation.ts';

/** The figures of a stage as they are now. */
export function statsOf(
  simulation: Simulation,
  { smoke, report, renderMs, drawCalls, writesDepth, scale }: Picture,
): StageStats {
  const { alive, waiting, steps, inputCount, isTruncated } = simulation.simulator;
  return {
    time: steps * STEP_SECONDS,
    steps,
    alive,
    waiting,
    inputs: inputCount,
    isTruncated,
    historyBytes: simulation.historyBytes,
    ...report,
    bodiesTotal: alive,
    castersTotal: smoke.throwsShadow ? alive : 0,
    simMs: simulation.stepMs,
    renderMs,
    drawCalls,
    writesDepth,
    scale,
  };
}
