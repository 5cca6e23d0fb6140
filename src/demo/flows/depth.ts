/** How far away is what lies under a position of the picture. */
import { Ray, Vector3 } from 'three';
import type { Stage } from '../../index.ts';
import {
  ALL_THAT_LIVES,
  FIRST_PART,
  OUT_OF_SIGHT,
  PLACE_FLOATS,
  type PathPoint,
  type TriangleMesh,
} from '../../internal.ts';

/** A position in CSS pixels from the top left of the picture. */
export interface PicturePlace {
  readonly x: number;
  readonly y: number;
}

/**
 * The depth of the nearest puff or surface at a position of the picture.
 * @returns a factor on the depth of the camera's target; 1 where nothing is
 */
export function depthAt(stage: Stage, place: PicturePlace): number {
  const nearest = Math.min(depthOfPuffs(stage, place), depthOfSurfaces(stage, place), depthOfModel(stage, place));
  return nearest < Infinity ? nearest : 1;
}

/** The place of the scene at a depth, a factor on that of the camera's target. */
export function placeAt(stage: Stage, { x, y }: PicturePlace, depth: number): PathPoint {
  const { sight } = stage;
  const { camera } = stage.running.picture.eye;
  const middle = sight.project(sight.centre)!;
  const place = sight.shift(sight.centre, [x - middle.x, middle.y - y, 0]);
  const eye = camera.getWorldPosition(new Vector3()).toArray();
  return place.map((part, axis) => eye[axis] + (part - eye[axis]) * depth) as unknown as PathPoint;
}

/** Of the centre of the nearest puff; infinite without any. */
function depthOfPuffs(stage: Stage, { x, y }: PicturePlace): number {
  const { sight } = stage;
  const { simulator } = stage.running.simulation;
  const { count, place } = simulator.arrange({ ...ALL_THAT_LIVES, blend: 1 }).rows;
  const rows = place.slice(0, count * PLACE_FLOATS);
  let nearest = Infinity;
  for (let row = 0; row < rows.length; row += PLACE_FLOATS) {
    const centre = [rows[row], rows[row + 1], rows[row + 2]] as const;
    const seen = sight.project(centre);
    if (!seen) continue;
    const metres = metresPerPixel(stage, centre);
    if (Math.hypot(seen.x - x, seen.y - y) * metres < rows[row + 3] && metres < nearest) nearest = metres;
  }
  return nearest / metresPerPixel(stage, sight.centre);
}

/** Of the nearest surface of the scene, except for those that bend; infinite without any. */
function depthOfSurfaces(stage: Stage, place: PicturePlace): number {
  const [eye, target] = [0, 1].map((depth) => placeAt(stage, place, depth));
  const depths = stage.running.opened.scene.surfaces.map(({ mesh, hidden, skin, rigid, part }) => {
    const carrier = part === undefined ? (rigid ?? -1) : FIRST_PART + part;
    const isDrawn = !hidden && !skin && stage.sight.change([0, 0, 0], carrier, -1)[1] > OUT_OF_SIGHT;
    if (!isDrawn) return Infinity;
    const [from, to] = [eye, target].map((end) => new Vector3(...stage.sight.change(end, -1, carrier)));
    return depthOfMesh(mesh, new Ray(from, to.sub(from)));
  });
  return Math.min(...depths);
}

/** The lengths of the ray to the nearest front face; infinite without any. */
function depthOfMesh({ positions, indices }: TriangleMesh, ray: Ray): number {
  const [a, b, c, hit] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  let nearest = Infinity;
  for (let corner = 0; corner < indices.length; corner += 3) {
    [a, b, c].forEach((vertex, index) => vertex.fromArray(positions, 3 * indices[corner + index]));
    if (!ray.intersectTriangle(a, b, c, true, hit)) continue;
    nearest = Math.min(nearest, hit.sub(ray.origin).length() / ray.direction.length());
  }
  return nearest;
}

/** Of the model of the stage, whose surfaces can bend; infinite where it is not. */
function depthOfModel(stage: Stage, { x, y }: PicturePlace): number {
  const point = stage.pickModel(x, y);
  if (!point) return Infinity;
  const { sight } = stage;
  const place = sight.change(point.position, point.node.rigid, -1);
  return metresPerPixel(stage, place) / metresPerPixel(stage, sight.centre);
}

/** Grows with the depth. */
function metresPerPixel({ sight }: Stage, place: PathPoint): number {
  const [x, y, z] = sight.shift(place, [1, 0, 0]);
  return Math.hypot(x - place[0], y - place[1], z - place[2]);
}
