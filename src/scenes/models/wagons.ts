/** The wagons: a tender with coal and two open wagons. They face +x; y = 0 is the top of the rails. */
import type { Color } from '../../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import { ballMesh } from './ball.ts';
import { axleMesh } from './locomotive.ts';
import { merged, placed } from './place.ts';
import { roundedBox } from './roundedBox.ts';

const DARK: Color = [82, 66, 88];
const HALF_LENGTH = 0.36;

/** The body, its load, and its frame with static wheels, whose plain shape hides that they do not turn. */
export function wagon(
  part: number,
  color: Color,
  load: { color: Color; heaps: readonly (readonly [x: number, y: number, z: number, radius: number])[] },
): SurfaceDescription[] {
  const look = { casts: true, inked: true, part };
  const heaps = load.heaps.map(([x, y, z, radius]) => placed(ballMesh(radius, 10), { at: [x, y, z] }));
  return [
    {
      name: `wagon ${part}`,
      mesh: placed(roundedBox([HALF_LENGTH, 0.17, 0.28], 0.05), { at: [0, 0.47, 0] }),
      color,
      ...look,
    },
    { name: `load ${part}`, mesh: merged(...heaps), color: load.color, ...look },
    { name: `frame ${part}`, mesh: frame(), color: DARK, ...look },
  ];
}

function frame(): TriangleMesh {
  const axle = (x: number) => placed(axleMesh(0.14), { at: [x, 0.14, 0] });
  const bar = placed(roundedBox([HALF_LENGTH + 0.1, 0.035, 0.06], 0.03, 5), { at: [0, 0.26, 0] });
  return merged(
    axle(0.2),
    axle(-0.2),
    bar,
    placed(roundedBox([HALF_LENGTH, 0.04, 0.24], 0.03, 5), { at: [0, 0.29, 0] }),
  );
}
