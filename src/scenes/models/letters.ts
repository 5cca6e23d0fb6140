/** Upright letters of round strokes that stand on the ground and face +z. */
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import { pipe, type Outline } from './lathe.ts';
import { merged } from './place.ts';

/** Height and width of a letter, and the radius of its strokes; metres. */
export const LETTER = { height: 1.3, width: 0.86, radius: 0.15 } as const;

type Path = readonly (readonly [x: number, y: number])[];

const { height, width, radius } = LETTER;
/** The centre lines stay within these. */
const [LEFT, RIGHT, TOP, MIDDLE, FOOT] = [radius - width / 2, width / 2 - radius, height - radius, 0.6, radius];

/** Strokes end round at the ends of their paths. */
const STEM: Path = [[LEFT, 0], [LEFT, height]]; // prettier-ignore
const STROKES = {
  F: [STEM, [[LEFT, TOP], [width / 2, TOP]], [[LEFT, MIDDLE], [RIGHT, MIDDLE]]],
  P: [STEM, [[LEFT, TOP], [0.02, TOP], [RIGHT - 0.05, TOP - 0.07], [RIGHT, 0.86], [RIGHT - 0.05, 0.64], [0.02, 0.55], [LEFT, 0.55]]],
  U: [[[LEFT, height], [LEFT, 0.7], [LEFT, 0.43], [-0.24, 0.29], [-0.14, 0.19], [0, FOOT], [0.14, 0.19], [0.24, 0.29], [RIGHT, 0.43], [RIGHT, 0.7], [RIGHT, height]]],
} as const satisfies Record<string, readonly Path[]>; // prettier-ignore

/** The closed mesh of a letter, centred about x = 0 with its foot at height 0. */
export function letter(name: keyof typeof STROKES): TriangleMesh {
  return merged(...STROKES[name].map((path: Path) => pipe(18, path, ...outlines(path))));
}

/** A stroke with round ends. */
function outlines(path: Path): Outline[] {
  const length = path.slice(1).reduce((sum, [x, y], at) => {
    const [dx, dy] = [x - path[at][0], y - path[at][1]];
    return sum + Math.sqrt(dx * dx + dy * dy);
  }, 0);
  const end = Math.min(0.3, (0.7 * radius) / length);
  return [
    [[0, 0], [0.6 * radius, 0.06 * end], [0.92 * radius, 0.4 * end], [radius, end]],
    [[radius, end], [radius, 1 - end]],
    [[radius, 1 - end], [0.92 * radius, 1 - 0.4 * end], [0.6 * radius, 1 - 0.06 * end], [0, 1]],
  ]; // prettier-ignore
}
