import type { Value } from '../../preset/parameter.ts';

/** The inputs of one parameter: they show a value and report what people make of it. */
export interface Control {
  readonly elements: readonly HTMLElement[];
  /** The input that the label names. */
  readonly id: string;
  show(value: Value): void;
}

export interface ControlListener {
  /** The value is on its way, many times a gesture. */
  change(value: Value): void;
  /** The gesture has ended. */
  settle(): void;
}
