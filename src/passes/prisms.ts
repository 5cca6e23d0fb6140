import { BufferAttribute, InstancedBufferGeometry } from 'three';

/** Number of sides of the prism that replaces a round volume. The corners are placed so that the areas are equal. */
const SIDES = 12;

/** What a corner belongs to. shaders/prismVolumes/prismVolumes.vert drops the copy of a cap that is out of order. */
const [SIDE, CAP_AT_FIRST, CAP_AT_LAST] = [0, 1, 2];

/**
 * Builds an instanced geometry of prisms that are closed at both ends, one for each row of `place`. Faces are
 * ordered back to front: side 0 faces away from the camera and the last side faces it. Each cap is present at the
 * beginning and at the end, and the shader draws one of the two. Each instance therefore increments the stencil before
 * it decrements it, so that clamping operations are exact. The attribute `corner` is (index around the prism, end + 2 x
 * part), where part is what the corner belongs to.
 */
export function prisms(): InstancedBufferGeometry {
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
  return geometry;
}

/**
 * Returns 0, 1, 11, 2, 10 and so on. Side 0 is between corners 0 and 1; the vertex shader turns it away from the
 * camera.
 */
function backToFront(): number[] {
  const pairs = Array.from({ length: SIDES / 2 }, (_, pair) => [pair, SIDES - pair]);
  return [...new Set([...pairs.flat(), SIDES / 2].map((side) => side % SIDES))];
}

function sideOf(first: number, side: number): number[] {
  const next = (side + 1) % SIDES;
  return [side, next, SIDES + next, side, SIDES + next, SIDES + side].map((corner) => first + corner);
}

/** Triangles of both caps, the first with reversed winding so that all faces point outwards. */
function caps(first: number): number[] {
  const fans = Array.from({ length: SIDES - 2 }, (_, fan) => [
    [0, fan + 2, fan + 1],
    [SIDES, SIDES + fan + 1, SIDES + fan + 2],
  ]);
  return fans.flat(2).map((corner) => first + corner);
}
