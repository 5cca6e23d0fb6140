/** The obstacles of the parameter table, handed out to calls. */
import { obstacleOf, underKey, vector, type PlaneRectangle } from '../plane.ts';
import type { Values } from '../../parameters/parameter.ts';
import type { ScenePlane } from '../../stage/sight.ts';
import { Slots } from './slots.ts';

/** Where unused obstacles are, metres. */
const AWAY = [900, 900, 0] as const;

/** The obstacles. When there are too many, the oldest goes. */
export class Obstacles {
  private readonly slots = new Slots();

  /** Values of an obstacle. @param owner frees it */
  claim(owner: object, place: PlaneRectangle, plane: ScenePlane): Values {
    return underKey(`colliders.${this.slots.claim(owner)}`, obstacleOf(place, plane));
  }

  /** Values that remove the obstacles of an owner; of all without one. */
  release(owner?: object): Values {
    const gone = this.slots.release(owner);
    return Object.assign(
      {},
      ...gone.map((index) => underKey(`colliders.${index}`, vector('position', AWAY))),
    ) as Values;
  }
}
