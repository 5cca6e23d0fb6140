/** The obstacles of the parameter table, handed out to calls. */
import { obstacleOf, underKey, vector, type PlaneRectangle } from '../plane.ts';
import { LIST_LIMIT } from '../../parameters/lists.ts';
import type { Values } from '../../parameters/parameter.ts';
import type { ScenePlane } from '../../stage/sight.ts';

/** Where unused obstacles are, metres. */
const AWAY = [900, 900, 0] as const;

/** The obstacles. When there are too many, the oldest goes. */
export class Obstacles {
  private readonly taken: (object | undefined)[] = Array.from({ length: LIST_LIMIT });
  private next = 0;

  /** Values of an obstacle. @param owner frees it */
  claim(owner: object, place: PlaneRectangle, plane: ScenePlane): Values {
    const free = this.taken.indexOf(undefined);
    const index = free >= 0 ? free : this.next++ % LIST_LIMIT;
    this.taken[index] = owner;
    return underKey(`colliders.${index}`, obstacleOf(place, plane));
  }

  /** Values that remove the obstacles of an owner; of all without one. */
  release(owner?: object): Values {
    const gone = this.taken.flatMap((each, index) => (each && (!owner || each === owner) ? [index] : []));
    for (const index of gone) this.taken[index] = undefined;
    return Object.assign(
      {},
      ...gone.map((index) => underKey(`colliders.${index}`, vector('position', AWAY))),
    ) as Values;
  }
}
