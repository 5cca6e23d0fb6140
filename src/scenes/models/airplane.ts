/** A small round biplane with a pilot: the nose points along +x, the right wing along +z. Metres, about its centre. */
import type { Color } from '../../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import { sin } from '../../simulator/exact/sine.ts';
import type { RigidPart, RigidShape } from '../../simulator/rigid.ts';
import type { Vector } from '../scene.ts';
import { ballMesh } from './ball.ts';
import { lathe } from './lathe.ts';
import { merged, placed } from './place.ts';
import { roundedBox } from './roundedBox.ts';

const RED: Color = [226, 78, 66];
const CREAM: Color = [250, 232, 190];
const YELLOW: Color = [248, 190, 76];
const DARK: Color = [84, 62, 78];
const SKIN: Color = [248, 204, 168];
const SCARF: Color = [66, 186, 178];

/** Axis of the propeller. */
export const HUB: Vector = [0.98, 0.02, 0];
/** Position of the scarf's knot. */
export const KNOT: Vector = [-0.34, 0.44, 0];
/** From the centre to a wing tip. */
export const HALF_SPAN = 1.3;
/** Indices of the moving parts. */
export const PROPELLER = 0;
export const SCARF_END = 1;

export function airplane(rigid: number): SurfaceDescription[] {
  const look = { casts: true, inked: true, rigid };
  const quiet = { ...look, casts: false };
  return [
    { name: 'fuselage', mesh: fuselage(), color: RED, ...look, group: 'body' },
    { name: 'tail', mesh: tail(), color: RED, ...look, group: 'body' },
    { name: 'cowling', mesh: cowling(), color: YELLOW, ...look },
    { name: 'wings', mesh: wings(), color: CREAM, ...look },
    { name: 'bands', mesh: bands(), color: RED, ...quiet, inked: false },
    { name: 'struts', mesh: struts(), color: DARK, ...quiet },
    { name: 'wheels', mesh: wheels(), color: DARK, ...quiet },
    {
      name: 'seat',
      mesh: placed(ballMesh(1, 10), { at: [-0.3, 0.3, 0], scale: [0.26, 0.08, 0.2] }),
      color: DARK,
      ...quiet,
    },
    { name: 'pilot', mesh: placed(ballMesh(0.17, 14), { at: [-0.32, 0.5, 0] }), color: SKIN, ...look, group: 'pilot' },
    { name: 'cap', mesh: cap(), color: [150, 92, 66], ...look, group: 'pilot' },
    { name: 'goggles', mesh: goggles(), color: DARK, ...quiet },
    { name: 'knot', mesh: knot(), color: SCARF, ...quiet, group: 'scarf' },
    { name: 'scarf', mesh: scarf(), color: SCARF, ...quiet, rigid: undefined, part: SCARF_END, group: 'scarf' },
    { name: 'propeller', mesh: propeller(), color: DARK, ...look, rigid: undefined, part: PROPELLER },
    { name: 'spinner', mesh: spinner(), color: RED, ...look },
  ];
}

/** The collider: the fuselage and the wings with a margin, as the air would part. */
export function airplaneHull(): RigidShape {
  const ahead = [0, 0, Math.SQRT1_2, Math.SQRT1_2] as const;
  const parts: RigidPart[] = [
    { shape: { type: 'capsule', halfHeight: 0.6, radius: 0.5 }, position: [0.1, 0.04, 0], rotation: ahead },
    { shape: { type: 'capsule', halfHeight: 0.42, radius: 0.26 }, position: [-0.95, 0.1, 0], rotation: ahead },
    { shape: { type: 'cuboid', halfExtents: [0.36, 0.14, HALF_SPAN] }, position: [0.24, 0.5, 0] },
    { shape: { type: 'cuboid', halfExtents: [0.33, 0.12, HALF_SPAN * 0.86] }, position: [0.16, -0.24, 0] },
  ];
  return { type: 'compound', parts };
}

/** Rotates a lathed mesh from the y axis to the x axis. */
function lying(mesh: TriangleMesh, at: Vector = [0, 0, 0]): TriangleMesh {
  return placed(mesh, { at, angles: [0, 0, -Math.PI / 2] });
}

function fuselage(): TriangleMesh {
  return lying(
    lathe(
      32,
      [[0, -1.42], [0.07, -1.38], [0.16, -1], [0.3, -0.4], [0.38, 0.2], [0.37, 0.62]],
      [[0.37, 0.62], [0, 0.62]],
    ),
  ); // prettier-ignore
}

function cowling(): TriangleMesh {
  return lying(
    lathe(
      32,
      [[0, 0.5], [0.36, 0.5]],
      [[0.36, 0.5], [0.43, 0.54], [0.44, 0.72], [0.38, 0.86], [0.26, 0.9]],
      [[0.26, 0.9], [0.2, 0.84]],
      [[0.2, 0.84], [0, 0.84]],
    ),
  ); // prettier-ignore
}

function spinner(): TriangleMesh {
  return lying(
    lathe(
      20,
      [[0, 0.8], [0.13, 0.8]],
      [[0.13, 0.8], [0.14, 0.94], [0.1, 1.06], [0, 1.12]],
    ),
  ); // prettier-ignore
}

/** Two blades about the hub, along y. */
function propeller(): TriangleMesh {
  const blade = (side: 1 | -1) =>
    placed(roundedBox([0.028, 0.3, 0.085], [0.028, 0.14, 0.085]), {
      at: [0, side * 0.33, 0],
      angles: [0, side * 0.5, 0],
    });
  return merged(blade(1), blade(-1));
}

function wings(): TriangleMesh {
  const wing = (y: number, x: number, span: number, chord: number) =>
    placed(roundedBox([chord, 0.065, span], [chord, 0.065, 0.3]), { at: [x, y, 0] });
  return merged(wing(0.5, 0.24, HALF_SPAN, 0.3), wing(-0.24, 0.16, HALF_SPAN * 0.86, 0.27));
}

/** Stripes around the wing tips. */
function bands(): TriangleMesh {
  const band = (y: number, x: number, z: number, chord: number) =>
    placed(roundedBox([chord + 0.008, 0.073, 0.09], [chord + 0.008, 0.073, 0.02]), { at: [x, y, z] });
  const [upper, lower] = [HALF_SPAN - 0.36, HALF_SPAN * 0.86 - 0.34];
  return merged(
    ...[1, -1].flatMap((side) => [band(0.5, 0.24, side * upper, 0.3), band(-0.24, 0.16, side * lower, 0.27)]),
  );
}

function struts(): TriangleMesh {
  const strut = (x: number, z: number, lean: number) =>
    placed(roundedBox([0.03, 0.37, 0.022], 0.02), { at: [x, 0.13, z], angles: [lean, 0, -0.1] });
  const leg = (z: number) =>
    placed(roundedBox([0.03, 0.17, 0.03], 0.025), { at: [0.42, -0.42, z], angles: [z, 0, 0.2] });
  return merged(...[0.92, -0.92].flatMap((z) => [strut(0.34, z, 0), strut(0.06, z, 0)]), ...[0.3, -0.3].map(leg));
}

function wheels(): TriangleMesh {
  const wheel = (z: number) => placed(roundedBox([0.15, 0.15, 0.06], [0.15, 0.15, 0.05]), { at: [0.46, -0.57, z] });
  return merged(
    wheel(0.36),
    wheel(-0.36),
    placed(roundedBox([0.07, 0.07, 0.03], [0.07, 0.07, 0.03]), { at: [-1.28, -0.12, 0] }),
  );
}

function tail(): TriangleMesh {
  const plane = placed(roundedBox([0.2, 0.045, 0.5], [0.2, 0.045, 0.24]), { at: [-1.22, 0.06, 0] });
  const fin = placed(roundedBox([0.2, 0.3, 0.045], [0.19, 0.2, 0.045]), { at: [-1.27, 0.3, 0], angles: [0, 0, 0.25] });
  return merged(plane, fin);
}

function cap(): TriangleMesh {
  return placed(lathe(24, [[0, -0.02], [0.18, -0.02]], [[0.18, -0.02], [0.182, 0.06], [0.14, 0.15], [0, 0.19]]), {
    at: [-0.34, 0.51, 0],
    angles: [0, 0, 0.25],
  }); // prettier-ignore
}

function goggles(): TriangleMesh {
  const glass = (z: number) => placed(ballMesh(1, 10), { at: [-0.175, 0.535, z], scale: [0.035, 0.06, 0.065] });
  return merged(glass(0.07), glass(-0.07));
}

function knot(): TriangleMesh {
  return placed(roundedBox([0.15, 0.055, 0.15], [0.15, 0.055, 0.15]), { at: [-0.33, 0.36, 0] });
}

/** A wavy strip that trails from the knot. */
function scarf(): TriangleMesh {
  const flat = placed(roundedBox([0.36, 0.035, 0.085], [0.1, 0.03, 0.05]), { at: [-0.34, 0, 0] });
  const { positions } = flat;
  const waved = positions.map((value, i) => (i % 3 === 1 ? value + 0.05 * sin(9 * positions[i - 1]) : value));
  return { ...flat, positions: waved };
}
