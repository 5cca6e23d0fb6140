import { BufferAttribute, InstancedBufferGeometry, type BufferGeometry } from 'three';

/** Sides of the prism that stands for a round volume. Its corners lie so that it is as wide as the round one. */
const SIDES = 12;

/** What a corner belongs to: shaders/prismVolumes/prismVolumes.vert takes out the caps of which it is not the turn. */
const [SIDE, CAP_AT_FIRST, CAP_AT_LAST] = [0, 1, 2];

/**
 * Prisms instead of nailboards, closed at both ends, for the rows of another geometry. Their faces come in the order of
 * back to front: side 0 looks away from the eye, the last one at it, and each cap stands at the beginning and at the
 * end, of which one is drawn. So each instance counts up before it counts down, and its operations may clamp.
 * Corners are (number round the prism, end + 2 x what it belongs to).
 */
export function prismsOf(rows: BufferGeometry): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  const corners: number[] = [];
  const index: number[] = [];
  const add = (part: number) => {
    const first = corners.length / 2;
    for (const end of [0, 1]) for (let number = 0; number < SIDES; ++number) corners.push(number, end + 2 * part);
    return first;
  };
  const [atFirst, sides, atLast] = [add(CAP_AT_FIRST), add(SIDE), add(CAP_AT_LAST)];
  index.push(...caps(atFirst));
  for (const side of backToFront()) index.push(...sideOf(sides, side));
  index.push(...caps(atLast));
  geometry.setIndex(index);
  geometry.setAttribute('corner', new BufferAttribute(new Float32Array(corners), 2));
  geometry.setAttribute('place', rows.getAttribute('place'));
  return geometry;
}

/** 0, 1, 11, 2, 10 and so on: side 0 lies between corners 0 and 1, about which the prism is turned. */
function backToFront(): number[] {
  const pairs = Array.from({ length: SIDES / 2 }, (_, pair) => [pair, SIDES - pair]);
  return [...new Set([...pairs.flat(), SIDES / 2].map((side) => side % SIDES))];
}

function sideOf(first: number, side: number): number[] {
  const next = (side + 1) % SIDES;
  return [side, next, SIDES + next, side, SIDES + next, SIDES + side].map((corner) => first + corner);
}

/** Both caps, the first one wound the other way, so that all faces look outwards. */
function caps(first: number): number[] {
  const fans = Array.from({ length: SIDES - 2 }, (_, fan) => [
    [0, fan + 2, fan + 1],
    [SIDES, SIDES + fan + 1, SIDES + fan + 2],
  ]);
  return fans.flat(2).map((corner) => first + corner);
}
