import type { Value } from '../../preset.ts';

/** The inputs of a parameter. They show a value and report changes. */
export interface Control {
  readonly elements: readonly HTMLElement[];
  /** The input that the label refers to. */
  readonly id: string;
  show(value: Value): void;
}

export interface ControlListener {
  /** Called on each change, often many times per gesture. */
  change(value: Value): void;
  /** Called at the end of a gesture. */
  settle(): void;
}
