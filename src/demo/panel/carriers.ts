import { FIRST_PART } from '../../internal.ts';
import { strings } from '../strings.ts';

/** Names of a scene's carriers, by index. */
export interface CarrierNames {
  readonly rigidNames: readonly string[];
  readonly partNames: readonly string[];
}

/** A carrier as an option for parameters such as `vortices.0.rigid`. */
export interface CarrierChoice {
  readonly value: number;
  readonly label: string;
}

/** The world first, then the rigids, then the parts. */
export function carrierChoices({ rigidNames, partNames }: CarrierNames): readonly CarrierChoice[] {
  return [
    { value: -1, label: strings.items.world },
    ...rigidNames.map((label, rigid) => ({ value: rigid, label })),
    ...partNames.map((label, part) => ({ value: FIRST_PART + part, label })),
  ];
}

/** Whether both lists are equal. Scenes differ in their carriers. */
export function areSame(some: readonly CarrierChoice[], others: readonly CarrierChoice[]): boolean {
  return JSON.stringify(some) === JSON.stringify(others);
}
