/** What the page of the measurement hands to the documentation, in whose frame it is. */

/** Times of a case: medians of the rounds. */
export interface CaseCost {
  /** Markdown. */
  readonly name: string;
  readonly puffs: number;
  /** As the display shows them, which limits them. */
  readonly framesPerSecond: number;
  /** Milliseconds of a step and a frame, without waiting for the display. */
  readonly milliseconds: number;
  /** The same over that of the first case, which is measured in turns with this one. */
  readonly ratio: number;
  /** Milliseconds of the step alone. */
  readonly stepMilliseconds: number;
  /** Milliseconds of the frame on the GPU; missing without timer queries. */
  readonly gpuMilliseconds?: number;
}

/** Draw calls of a frame on the GPU. */
export interface PassCost {
  readonly name: string;
  readonly milliseconds: number;
}

export interface CostReport {
  /** Name of the GPU, as far as the browser tells it. */
  readonly gpu: string;
  /** CSS pixels. */
  readonly width: number;
  readonly height: number;
  readonly rounds: number;
  readonly cases: readonly CaseCost[];
  /** Of the first case; empty without timer queries. */
  readonly passes: readonly PassCost[];
}

export interface CostOptions {
  readonly rounds: number;
  readonly signal: AbortSignal;
  /** @param share of the work that is done, 0 to 1 */
  readonly onProgress: (share: number, name: string) => void;
}

/**
 * @throws Error when the machine cannot draw smoke or loses its graphics; the reason of the signal
 */
export type MeasureCosts = (options: CostOptions) => Promise<CostReport>;
