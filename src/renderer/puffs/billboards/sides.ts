/** The sides of puffs that billboards show. */
import type { Lobe, PuffMesh, PuffShape } from '../shapes.ts';

/**
 * The shapes for billboards, seen from +z: all sides of the first one, then those of the next. Lobes behind the centre
 * plane move up to it. The outline does not change, and the relief has no deep steps along it that would interrupt the
 * outline where a puff touches the floor. A mesh keeps its own relief. It shrinks with its lobes to fit the unit ball,
 * beyond which nothing of a billboard is drawn. A drawing and a tile of a sheet have only a front.
 * @param sides 1, 2, 4 or 8, evenly spaced around the y axis; the first one is the front
 */
export function billboardShapes(shapes: readonly PuffShape[], sides = 1): readonly PuffShape[] {
  const turns = EIGHTHS.filter((_, eighth) => eighth % (EIGHTHS.length / sides) === 0);
  return shapes.flatMap((shape) => {
    if (hasOnlyFront(shape)) return turns.map(() => shape);
    const reach = shape.mesh ? reachOfMesh(shape.mesh) : 1;
    return turns.map((turn) => sideOf(shape, turn, reach));
  });
}

/** Whether all sides of a shape are the same. */
export function hasOnlyFront({ drawing, sheet }: PuffShape): boolean {
  return drawing !== undefined || sheet !== undefined;
}

/** Whether a shape for billboards is a picture of its own, which its lobes do not stand for. */
export function isOwnPicture(shape: PuffShape): boolean {
  return 'mesh' in shape || 'drawing' in shape || 'sheet' in shape;
}

/** Cosine and sine of eighths of a turn. Engines differ in the last bit of Math.cos. */
const EIGHTHS: readonly Turn[] = [
  [1, 0], [Math.SQRT1_2, Math.SQRT1_2], [0, 1], [-Math.SQRT1_2, Math.SQRT1_2],
  [-1, 0], [-Math.SQRT1_2, -Math.SQRT1_2], [0, -1], [Math.SQRT1_2, -Math.SQRT1_2],
]; // prettier-ignore

type Turn = readonly [cosine: number, sine: number];

/** @param reach becomes 1 */
function sideOf({ name, lobes, mesh }: PuffShape, turn: Turn, reach: number): PuffShape {
  const [cosine, sine] = turn;
  const turned = lobes.map(({ center: [x, y, z], radius }): Lobe => {
    const height = (cosine * z - sine * x) / reach;
    const place = [(cosine * x + sine * z) / reach, y / reach, mesh ? height : Math.max(height, 0)] as const;
    return { center: place, radius: radius / reach };
  });
  if (!mesh) return { name, lobes: turned };
  return {
    name,
    lobes: turned,
    // When it is baked, so that the meshes of all sides do not take memory at once.
    get mesh() {
      return { ...mesh, positions: turnedBy(turn, mesh.positions, reach), normals: turnedBy(turn, mesh.normals, 1) };
    },
  };
}

function turnedBy([cosine, sine]: Turn, vectors: Float32Array, reach: number): Float32Array {
  const turned = new Float32Array(vectors.length);
  for (let at = 0; at < vectors.length; at += 3) {
    turned[at] = (cosine * vectors[at] + sine * vectors[at + 2]) / reach;
    turned[at + 1] = vectors[at + 1] / reach;
    turned[at + 2] = (cosine * vectors[at + 2] - sine * vectors[at]) / reach;
  }
  return turned;
}

/** Distance of the farthest vertex from the centre of the puff, at least 1. */
function reachOfMesh({ positions }: PuffMesh): number {
  let squared = 1;
  for (let at = 0; at < positions.length; at += 3) {
    const [x, y, z] = [positions[at], positions[at + 1], positions[at + 2]];
    squared = Math.max(squared, x * x + y * y + z * z);
  }
  return Math.sqrt(squared);
}
