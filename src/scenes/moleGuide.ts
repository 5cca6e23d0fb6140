/** The behaviour of the mole: it digs to the nearest toy, kicks it up, looks around, and digs on. */
import { Vector2 } from 'three';
import { sin } from '../simulator/exact/sine.ts';
import { DESERT_RADIUS } from './models/desert.ts';
import { MOLE_HALF, MOLE_RADIUS } from './models/mole.ts';
import { placement } from './models/place.ts';
import type { Guide, SceneState, Placement } from './scene.ts';

/** Seconds per cycle, and the phases: digging, emerging, looking around, retreating. */
const PERIOD = 3.8;
const [DIGGING, UP, LOOKING, DOWN] = [1.8, 0.15, 1.1, 0.35];
/** Heights of the mole's centre, metres. */
const [HIDDEN, OUT] = [-MOLE_HALF - MOLE_RADIUS - 0.05, 0.24];
/** m/s. */
const TOP_SPEED = 2.2;
/** The mole emerges slightly beyond the toy, so that the toy flies inwards. */
const BEYOND = 0.14;
/** A toy above this height does not lie on the sand, so the mole ignores it. */
const LYING = 0.9;
const FARTHEST = DESERT_RADIUS - 0.75;

/** Height of the mole's centre; the sand is at 0. */
export function moleHeight(seconds: number): number {
  const since = (seconds % PERIOD) - DIGGING;
  const share = Math.min(Math.max(since / UP, 0), Math.max((UP + LOOKING + DOWN - since) / DOWN, 0), 1);
  return HIDDEN + (OUT - HIDDEN) * share * share * (3 - 2 * share);
}

/** The initial pose, below the sand. */
export const MOLE_START: Placement = placement([-1.3, HIDDEN, 0.7]);

/**
 * @param mole index of its rigid
 * @param toys indices of the rigids that it kicks
 */
export function moleGuide(mole: number, toys: readonly number[]): Guide {
  return (moment) => {
    const { seconds, dt, pose } = moment;
    const [x, , z] = pose(mole).position;
    const place = new Vector2(x, z);
    if (seconds % PERIOD < DIGGING) {
      const way = goal(moment, place, toys).sub(place);
      place.add(way.clampLength(0, TOP_SPEED * dt));
    }
    const look = 0.5 * sin(2.6 * seconds) - 0.1 * place.x;
    return [{ rigid: mole, ...placement([place.x, moleHeight(seconds), place.y], [0, look, 0]) }];
  };
}

/** Position of the nearest toy on the sand; the centre if there is none. */
function goal({ pose }: SceneState, from: Vector2, toys: readonly number[]): Vector2 {
  const lying = toys
    .map((toy) => pose(toy).position)
    .filter(([, y]) => y > 0 && y < LYING)
    .map(([x, , z]) => new Vector2(x, z))
    .filter((place) => place.length() < DESERT_RADIUS);
  lying.sort((a, b) => a.distanceTo(from) - b.distanceTo(from));
  const nearest = lying[0] ?? new Vector2();
  return nearest.setLength(nearest.length() + BEYOND).clampLength(0, FARTHEST);
}
