import type { TriangleMesh } from '../renderer/passes/extrusion.ts';
import { sin } from '../simulator/exact/sine.ts';
import { emitterRig } from './emitterRig.ts';
import { ballMesh } from './models/ball.ts';
import { island, trees } from './models/island.ts';
import { lathe } from './models/lathe.ts';
import { merged, placed } from './models/place.ts';
import { roundedBox } from './models/roundedBox.ts';
import type { Scene, Vector } from './scene.ts';

/** An island at night with mortars, from which shells rise and burst. */
export function firework(): Scene {
  const look = { casts: true, inked: true };
  return {
    name: 'firework',
    rig: RIG,
    rigids: [],
    rigidNames: [],
    surfaces: [
      ...island(2.6, [92, 132, 128], [112, 92, 128]),
      { name: 'stars', mesh: stars(), color: [226, 224, 255], casts: false, inked: false, glows: true },
      ...trees(TREES, [78, 120, 132], [112, 84, 100]),
      { name: 'box', mesh: placed(roundedBox([0.82, 0.14, 0.26], 0.06), { at: [0, 0.12, 0] }), color: [190, 116, 92], ...look }, // prettier-ignore
      { name: 'mortars', mesh: merged(...MORTARS.map((at) => placed(mortar(), { at }))), color: [236, 150, 96], ...look }, // prettier-ignore
    ],
    camera: { target: [0, 2.7, 0], azimuth: 0.12, elevation: 0.06, distance: 12.6, fieldOfView: 0.56 },
    portrait: { target: [0, 2.9, 0], minWidth: 0.62 },
    backdrop: { top: [16, 18, 56], bottom: [74, 62, 124] },
  };
}

/** Feet of the mortars. */
const MORTARS: readonly Vector[] = [[-0.5, 0.2, 0], [0, 0.2, 0], [0.5, 0.2, 0]]; // prettier-ignore
const TREES = [[-1.75, -0.6, 1.2], [-1.25, -1.3, 0.9], [1.7, -0.75, 1.1], [1.95, 0.2, 0.75]] as const; // prettier-ignore

/** Far stars of two sizes, behind the island as seen from the front. */
function stars(): TriangleMesh {
  return merged(
    ...Array.from({ length: 26 }, (_, index) => {
      const [along, up] = [sin(12.9 * index), sin(7.3 * index + 1.7)];
      return placed(ballMesh(index % 4 === 0 ? 0.07 : 0.04, 5), { at: [13 * along, 5 + 6.5 * up, -12] });
    }),
  );
}

function mortar(): TriangleMesh {
  return lathe(
    20,
    [[0, 0], [0.15, 0]],
    [[0.15, 0], [0.17, 0.46]],
    [[0.17, 0.46], [0.12, 0.48]],
    [[0.12, 0.48], [0.11, 0.12], [0, 0.1]],
  ); // prettier-ignore
}

/** A shell that bursts on all sides. */
const burst = (index: number, position: Vector): Record<string, number> =>
  emitter(index, position, { shape: 2, radius: 0.12, speed: 6.2, speedVariation: 0.12, spread: Math.PI, size: 0.34 });

/** A rising shell, three bursts, their sparks and their cores. */
const RIG: Readonly<Record<string, number>> = {
  ...emitter(0, [0, 0.6, 0], { shape: 0, speed: 0.3, spread: 0.6, size: 0.17 }),
  ...burst(1, [-1.75, 3.4, 0]),
  ...burst(2, [1.75, 3.9, -0.2]),
  ...burst(3, [0, 4.3, 0.1]),
  ...burst(4, [0, 4.3, 0.1]),
  ...burst(5, [0, 4.3, 0.1]),
  'gravity.acceleration': 1.2,
  'buoyancy.coolingTime': 0.9,
  'drag.rate': 1.5,
};

function emitter(index: number, [x, y, z]: Vector, own: Record<string, number>): Record<string, number> {
  const all = {
    'position.x': x,
    'position.y': y,
    'position.z': z,
    sizeVariation: 0.2,
    temperature: 1,
    share: 0,
    ...own,
  };
  return emitterRig(index, all);
}
