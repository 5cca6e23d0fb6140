/** A clearing at night: a ring of stones with logs, a tent, a seat, and a marshmallow over the fire. */
import type { Color } from '../../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import { acos, atan2 } from '../../simulator/exact/arc.ts';
import { cos, hypot, sin } from '../../simulator/exact/sine.ts';
import type { Vector } from '../scene.ts';
import { ballMesh } from './ball.ts';
import { friendlyFace } from './face.ts';
import { lathe } from './lathe.ts';
import { merged, placed } from './place.ts';
import { roundedBox } from './roundedBox.ts';

const STONE: Color = [158, 148, 164];
const BARK: Color = [150, 96, 72];
const CUT: Color = [238, 196, 138];
const TENT: Color = [236, 130, 86];
const INSIDE: Color = [92, 56, 74];
const SWEET: Color = [255, 246, 236];
const FACE: Color = [70, 42, 52];
const CHEEK: Color = [246, 156, 140];

/** Position of the marshmallow. */
const TREAT: Vector = [0.66, 0.98, 0.46];

export function camp(): SurfaceDescription[] {
  const look = { casts: true, inked: true };
  const quiet = { casts: false, inked: false };
  const { features, cheeks } = friendlyFace(0.24, 0.16);
  const angles: Vector = [0, 0.2, 0];
  const front: Vector = [TREAT[0] + 0.16 * sin(0.2), TREAT[1] + 0.02, TREAT[2] + 0.16 * cos(0.2)];
  return [
    { name: 'stones', mesh: stones(), color: STONE, ...look },
    { name: 'logs', mesh: logs(), color: BARK, ...look },
    { name: 'cuts', mesh: cuts(), color: CUT, ...quiet },
    { name: 'seat', mesh: between([-1.6, 0.2, 0.32], [-0.88, 0.2, 1.2], 0.2, 0.2), color: BARK, ...look },
    { name: 'tent', mesh: tent(0, 1), color: TENT, ...look },
    { name: 'door', mesh: tent(0.02, 0.7), color: INSIDE, ...quiet },
    { name: 'stick', mesh: stick(), color: BARK, ...look },
    { name: 'treat', mesh: treat(), color: SWEET, ...look },
    { name: 'face', mesh: placed(features, { at: front, angles }), color: FACE, ...quiet },
    { name: 'cheeks', mesh: placed(cheeks, { at: front, angles }), color: CHEEK, ...quiet },
  ];
}

function stones(): TriangleMesh {
  const count = 11;
  return merged(
    ...Array.from({ length: count }, (_, index) => {
      const angles = (2 * Math.PI * index) / count;
      const size = 0.125 + 0.03 * sin(5.3 * index);
      return placed(ballMesh(1, 9), {
        at: [0.62 * cos(angles), 0.07, 0.62 * sin(angles)],
        scale: [1.25 * size, size, size],
        angles: [0, 1.5708 - angles + 0.3 * sin(index), 0],
      });
    }),
  );
}

/** Angles of the logs, which lean together with their tops over the fire. */
const LEANING = [0.4, 1.7, 2.9, 4.1, 5.3] as const;

/** `from` and `to` are fractions of the length from foot to top; values outside 0 to 1 extend beyond the ends. */
function leaning(radius: number, from: number, to: number): TriangleMesh[] {
  return LEANING.map((round) => {
    const at = (share: number): Vector => {
      const out = 0.5 - 0.47 * share;
      return [out * cos(round), 0.06 + 0.5 * share, out * sin(round)];
    };
    return between(at(from), at(to), radius, radius);
  });
}

function logs(): TriangleMesh {
  return merged(...leaning(0.085, 0, 1));
}

/** The light cut faces of the logs. */
function cuts(): TriangleMesh {
  return merged(
    ...leaning(0.065, -0.012, 0.01),
    ...leaning(0.065, 0.99, 1.012),
    between([-1.62, 0.2, 0.3], [-0.86, 0.2, 1.22], 0.16, 0.16),
  );
}

/** A round bar between two points. */
function between(foot: Vector, tip: Vector, radius: number, tipRadius: number): TriangleMesh {
  const way = tip.map((place, axis) => place - foot[axis]);
  const length = hypot(...way);
  const bar = lathe(
    14,
    [[0, 0], [radius, 0]],
    [[radius, 0], [tipRadius, length]],
    [[tipRadius, length], [0, length]],
  ); // prettier-ignore
  const lean = acos(way[1] / length);
  return placed(placed(bar, { angles: [0, 0, -lean] }), { at: foot, angles: [0, atan2(-way[2], way[0]), 0] });
}

/**
 * A ridge tent: a prism with rounded edges.
 * @param out how far its ends extend, metres
 * @param size a factor
 */
function tent(out: number, size: number): TriangleMesh {
  const box = roundedBox([0.5, 0.5, 0.6 + out], [0.06, 0.06, 0.05]);
  const [positions, normals] = [box.positions.slice(), box.normals.slice()];
  for (let from = 0; from < positions.length; from += 3) {
    const share = (positions[from + 1] + 0.5) / 1;
    positions[from] *= size * (1.25 - 1.17 * share);
    positions[from + 1] = size * (positions[from + 1] + 0.5) - 0.02;
    // Tilts the normals with the slope of the sides.
    const [x, y] = [normals[from], normals[from + 1]];
    const length = hypot(x, y + Math.abs(x) * 1.1, normals[from + 2]) || 1;
    normals[from] = x / length;
    normals[from + 1] = (y + Math.abs(x) * 1.1) / length;
    normals[from + 2] /= length;
  }
  return placed({ ...box, positions, normals }, { at: [-1.3, 0, -0.95], angles: [0, 0.42, 0], scale: 1.25 });
}

function stick(): TriangleMesh {
  return between([1.75, -0.02, 0.86], [TREAT[0] - 0.1, TREAT[1] + 0.06, TREAT[2] - 0.03], 0.028, 0.016);
}

function treat(): TriangleMesh {
  const outline = [[0.13, -0.13], [0.16, -0.1], [0.16, 0.1], [0.13, 0.13]] as const; // prettier-ignore
  return placed(lathe(28, [[0, -0.135], [0.13, -0.13]], outline, [[0.13, 0.13], [0, 0.135]]), { at: TREAT }); // prettier-ignore
}
