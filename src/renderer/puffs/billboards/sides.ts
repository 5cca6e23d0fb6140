/** The sides of puffs that billboards show. */
import type { Lobe, PuffMesh, PuffShape } from '../shapes.ts';

/**
 * The shapes for billboards, seen from +z: all sides of the first one, then those of the next. Lobes behind the centre
 * plane move up to it. The outline does not change, and the relief has no deep steps along it that would interrupt the
 * outline where a puff touches the floor. A mesh keeps its own relief. It shrinks with its lobes to fit the unit ball,
 * beyond which nothing of a billboard is drawn.
 * @param sides 1, 2, 4 or 8, evenly spaced around the y axis; the first one is the front
 */
export function billboardShapes(shapes: readonly PuffShape[], sides = 1): readonly PuffShape[] {
  const turns = EIGHTHS.filter((_, eighth) => eighth % (EIGHTHS.length / sides) === 0);
  return shapes.flatMap((shape) => {
    const fitted = shape.mesh ? withinUnitBall(shape.lobes, shape.mesh) : shape;
    return turns.map((turn) => sideOf({ ...fitted, name: shape.name }, turn));
  });
}

/** Cosine and sine of eighths of a turn. Engines differ in the last bit of Math.cos. */
const EIGHTHS: readonly Turn[] = [
  [1, 0], [Math.SQRT1_2, Math.SQRT1_2], [0, 1], [-Math.SQRT1_2, Math.SQRT1_2],
  [-1, 0], [-Math.SQRT1_2, -Math.SQRT1_2], [0, -1], [Math.SQRT1_2, -Math.SQRT1_2],
]; // prettier-ignore

type Turn = readonly [cosine: number, sine: number];

function sideOf({ name, lobes, mesh }: PuffShape, turn: Turn): PuffShape {
  const [cosine, sine] = turn;
  const turned = lobes.map(({ center: [x, y, z], radius }): Lobe => {
    const height = cosine * z - sine * x;
    return { center: [cosine * x + sine * z, y, mesh ? height : Math.max(height, 0)], radius };
  });
  if (!mesh) return { name, lobes: turned };
  return {
    name,
    lobes: turned,
    // When it is baked, so that the meshes of all sides do not take memory at once.
    get mesh() {
      return { ...mesh, positions: turnedBy(turn, mesh.positions), normals: turnedBy(turn, mesh.normals) };
    },
  };
}

function turnedBy([cosine, sine]: Turn, vectors: Float32Array): Float32Array {
  const turned = vectors.slice();
  for (let at = 0; at < vectors.length; at += 3) {
    turned[at] = cosine * vectors[at] + sine * vectors[at + 2];
    turned[at + 2] = cosine * vectors[at + 2] - sine * vectors[at];
  }
  return turned;
}

function withinUnitBall(lobes: readonly Lobe[], mesh: PuffMesh): Pick<PuffShape, 'lobes' | 'mesh'> {
  const { positions } = mesh;
  let squared = 1;
  for (let at = 0; at < positions.length; at += 3) {
    squared = Math.max(squared, positions[at] ** 2 + positions[at + 1] ** 2 + positions[at + 2] ** 2);
  }
  const reach = Math.sqrt(squared);
  return {
    lobes: lobes.map(({ center: [x, y, z], radius }) => ({
      center: [x / reach, y / reach, z / reach],
      radius: radius / reach,
    })),
    mesh: { ...mesh, positions: positions.map((at) => at / reach) },
  };
}
