import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import { ballMesh } from './ball.ts';
import { pipe } from './lathe.ts';
import { merged, placed } from './place.ts';

/**
 * A friendly face about the origin that faces +z, for a surface that is round about a vertical axis.
 * @param size from cheek to cheek, metres
 * @param radius of the surface
 */
export function friendlyFace(size: number, radius: number): { features: TriangleMesh; cheeks: TriangleMesh } {
  const half = size / 2;
  const out = (x: number) => Math.sqrt(radius * radius - x * x) - radius;
  const dot = (x: number, y: number, scale: readonly [number, number, number]) =>
    placed(ballMesh(1, 10), {
      at: [x * half, y * half, out(x * half)],
      scale: [scale[0] * half, scale[1] * half, scale[2] * half],
    });
  const smile = pipe(
    8,
    [[-0.3, 0.07], [-0.18, -0.08], [0, -0.14], [0.18, -0.08], [0.3, 0.07]],
    [[0, 0], [0.04, 0.01]],
    [[0.04, 0.01], [0.07, 0.5], [0.04, 0.99]],
    [[0.04, 0.99], [0, 1]],
  ); // prettier-ignore
  const eye = [0.15, 0.2, 0.1] as const;
  const cheek = [0.2, 0.13, 0.1] as const;
  return {
    features: merged(
      dot(-0.55, 0.2, eye),
      dot(0.55, 0.2, eye),
      placed(smile, { at: [0, -0.02 * half, 0.01 * half], scale: half }),
    ),
    cheeks: merged(dot(-0.85, -0.14, cheek), dot(0.85, -0.14, cheek)),
  };
}
