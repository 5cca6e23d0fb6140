/**
 * Lines along the sharp edges of a box and its intersection with a floor, compared with the projected visible edges.
 */
import { OrthographicCamera, PerspectiveCamera, Vector3, type Camera } from 'three';
import { PLAIN_STYLE, takePicture } from '../../lab.ts';
import { box } from '../../solids.ts';

const SIZE = 200;
const HALF = 0.5;
const WIDTH = 3;

/** Ink inside a box: pixels that belong to a line, those of them without ink, and ink elsewhere. */
export interface CreaseReport {
  expected: number;
  missing: number;
  stray: number;
}

export interface CreaseCase {
  projection: 'perspective' | 'orthographic';
  /** Distance of the camera, metres. */
  distance: number;
  /** Whether a wall is in front of the box. */
  behind?: boolean;
  /** Depth of the box in a floor, metres; the test then measures the line on the floor. No floor where absent. */
  sunk?: number;
  reversedDepth?: boolean;
}

export function creasesOf({ projection, distance, behind = false, sunk, reversedDepth }: CreaseCase): CreaseReport {
  const camera = cameraOf(projection, distance);
  const surface = { color: [200, 120, 60], casts: false, inked: true } as const;
  const surfaces = [{ ...surface, name: 'box', mesh: box([0, 0, 0], [HALF, HALF, HALF]) }];
  if (behind) surfaces.push({ ...surface, name: 'wall', mesh: wallBefore(camera) });
  if (sunk !== undefined)
    surfaces.push({ ...surface, name: 'floor', mesh: box([0, sunk - HALF - 0.2, 0], [2, 0.2, 2]) });
  const style = { creases: true, outlineWidth: WIDTH, inkSwell: 0, shadows: false } as const;
  const { pixels } = takePicture({ width: SIZE, height: SIZE, puffs: [], surfaces, camera, style, reversedDepth });
  const [corner, ...ends] = cornerOf(sunk).map((place) => onScreen(place, camera));
  const report = { expected: 0, missing: 0, stray: 0 };
  for (let pixel = 0; pixel < SIZE * SIZE; ++pixel) {
    const at = new Vector3((pixel % SIZE) + 0.5, Math.floor(pixel / SIZE) + 0.5, 0);
    // Outside the silhouette, where hulls draw.
    if (at.distanceTo(corner) > 0.6 * Math.min(...ends.map((end) => end.distanceTo(corner)))) continue;
    // Ribbons have square ends, which protrude where two ribbons meet at an angle.
    if (sunk !== undefined && at.distanceTo(corner) < WIDTH) continue;
    const away = Math.min(...ends.map((end) => distanceTo(at, corner, end)));
    const isInk = PLAIN_STYLE.inkColor.every((channel, index) => pixels[4 * pixel + index] === channel);
    if (away < WIDTH / 2 - 0.3) report.expected++;
    if (away < WIDTH / 2 - 0.3 && !isInk) report.missing++;
    if (away > WIDTH / 2 + 0.3 && isInk) report.stray++;
  }
  return report;
}

/** The corner that faces the camera, or the one on the floor, and the end points of its three edges. */
function cornerOf(sunk?: number): Vector3[] {
  const height = sunk === undefined ? HALF : sunk - HALF;
  const corners = [
    [1, height, 1],
    [-1, height, 1],
    [1, -Math.sign(height) * HALF, 1],
    [1, height, -1],
  ];
  return corners.map(([x, y, z]) => new Vector3(x * HALF, y, z * HALF));
}

function cameraOf(projection: string, distance: number): Camera {
  const half = 1.1;
  const camera =
    projection === 'perspective'
      ? new PerspectiveCamera((360 / Math.PI) * Math.atan(half / distance), 1, 0.1, 60)
      : new OrthographicCamera(-half, half, half, -half, 0.1, 60);
  camera.position.set(0.7, 0.55, 0.5).setLength(distance);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return camera;
}

/** A thin board between the camera and the box. */
function wallBefore(camera: Camera): ReturnType<typeof box> {
  const { x, y, z } = camera.position.clone().setLength(1.3);
  return box([x, y, z], [0.02, 3, 3]);
}

function onScreen(place: Vector3, camera: Camera): Vector3 {
  const { x, y } = place.project(camera);
  return new Vector3((0.5 + 0.5 * x) * SIZE, (0.5 + 0.5 * y) * SIZE, 0);
}

function distanceTo(point: Vector3, from: Vector3, to: Vector3): number {
  const way = to.clone().sub(from);
  const share = Math.min(1, Math.max(0, point.clone().sub(from).dot(way) / way.lengthSq()));
  return point.distanceTo(from.clone().addScaledVector(way, share));
}
