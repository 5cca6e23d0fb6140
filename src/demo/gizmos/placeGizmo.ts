import type { Stage } from '../../index.ts';
import { itemLabel } from '../../internal.ts';
import { findParameter, type AnyValues, type Values } from '../../preset.ts';
import { clampTo, type Gizmo } from './gizmo.ts';
import type { Changes } from '../editor/editor.ts';
import type { Direction } from '../input/keyboard.ts';

type Vector = readonly [x: number, y: number, z: number];
type List = 'emitters' | 'vortices';

const AXES = ['x', 'y', 'z'] as const;

/** Handle of an emitter or a vortex, at its position in the scene or on its carrier. */
export class PlaceGizmo implements Gizmo {
  readonly key: string;
  readonly icon: 'emitter' | 'vortex';
  private readonly label: string;
  private readonly sight: () => Stage['sight'];
  private readonly offset: () => { x: number; y: number };

  /** @param offset of the canvas from the overlay, in CSS pixels */
  constructor(list: List, index: number, sight: () => Stage['sight'], offset: () => { x: number; y: number }) {
    this.key = `${list}.${index}`;
    this.icon = list === 'emitters' ? 'emitter' : 'vortex';
    this.label = itemLabel(list, index);
    this.sight = sight;
    this.offset = offset;
  }

  describe(): string {
    return this.label;
  }

  place(values: Values): { x: number; y: number } | undefined {
    const seen = this.sight().project(this.positionIn(values), this.carrierIn(values));
    const { x, y } = this.offset();
    return seen && { x: seen.x + x, y: seen.y + y };
  }

  move(from: Values, way: Direction): Changes {
    return this.at(this.sight().shift(this.positionIn(from), way, this.carrierIn(from)));
  }

  /** Attaches it to a carrier without moving it. Carriers are numbered as in `carrierChoices`; -1 detaches. */
  ride(from: Values, carrier: number): Changes {
    const place = this.sight().change(this.positionIn(from), this.carrierIn(from), carrier);
    return { ...this.at(place), [`${this.key}.rigid`]: carrier };
  }

  /** Index of its carrier; -1 for none. */
  carrierIn(values: AnyValues): number {
    return Number(values[`${this.key}.rigid`] ?? -1);
  }

  private at(place: Vector): Changes {
    return Object.fromEntries(
      AXES.map((axis, index) => [
        `${this.key}.position.${axis}`,
        clampTo(`${this.key}.position.${axis}`, place[index], 3),
      ]),
    );
  }

  private positionIn(values: AnyValues): Vector {
    const [x, y, z] = AXES.map((axis) => {
      const key = `${this.key}.position.${axis}`;
      return Number(values[key] ?? findParameter(key)!.default);
    });
    return [x, y, z];
  }
}
