/** A smiling steam locomotive: it faces +x, and y = 0 is the top of the rails. Metres. */
import type { Color } from '../../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import type { RigidShape } from '../../simulator/rigid.ts';
import type { Vector } from '../scene.ts';
import { ballMesh } from './ball.ts';
import { lathe, pipe } from './lathe.ts';
import { merged, placed } from './place.ts';
import { roundedBox } from './roundedBox.ts';

const GREEN: Color = [58, 150, 124];
const RED: Color = [222, 84, 70];
const CREAM: Color = [252, 232, 190];
const BRASS: Color = [246, 192, 84];
const DARK: Color = [82, 66, 88];
const CHEEK: Color = [244, 148, 130];

/** The opening of the chimney. */
export const CHIMNEY: Vector = [0.44, 1.12, 0];
/** The outlet of the cylinders, low in front of the wheels. */
export const CYLINDER: Vector = [0.56, 0.2, 0];
/** Radius of the driving wheels, and the distance of the crank pins from their centres. */
export const WHEEL_RADIUS = 0.22;
export const CRANK = 0.11;
/** Positions of the axles along x; the first two are driven. */
export const AXLES = [-0.36, 0.12, 0.55] as const;
/** Half the distance between the wheels of an axle. */
const HALF_GAUGE = 0.2;
const RODS = HALF_GAUGE + 0.075;

/**
 * @param rigid index of the rigid that carries it
 * @param parts indices of its axles, and of its right and left rods
 */
export function locomotive(
  rigid: number,
  parts: { axles: readonly number[]; rods: readonly [number, number] },
): SurfaceDescription[] {
  const look = { casts: true, inked: true, rigid };
  const quiet = { ...look, casts: false };
  return [
    { name: 'frame', mesh: frame(), color: RED, ...look },
    { name: 'boiler', mesh: boiler(), color: GREEN, ...look },
    { name: 'hoops', mesh: hoops(), color: BRASS, ...quiet, inked: false },
    { name: 'smokebox', mesh: smokebox(), color: DARK, ...look },
    { name: 'front', mesh: front(), color: CREAM, ...look },
    { name: 'face', mesh: face(), color: DARK, ...quiet, inked: false },
    { name: 'cheeks', mesh: cheeks(), color: CHEEK, ...quiet, inked: false },
    { name: 'chimney', mesh: chimney(), color: DARK, ...look, group: 'chimney' },
    { name: 'rim', mesh: rim(), color: RED, ...look, group: 'chimney' },
    { name: 'dome', mesh: dome(), color: BRASS, ...look },
    { name: 'cab', mesh: cab(), color: RED, ...look },
    { name: 'windows', mesh: windows(), color: CREAM, ...quiet },
    { name: 'roof', mesh: roof(), color: DARK, ...look },
    { name: 'cylinders', mesh: cylinders(), color: DARK, ...look },
    ...AXLES.map((_, axle) => ({
      name: `axle ${axle}`,
      mesh: axleMesh(axle < 2 ? WHEEL_RADIUS : WHEEL_RADIUS * 0.62),
      color: BRASS,
      casts: true,
      inked: true,
      part: parts.axles[axle],
    })),
    ...parts.rods.map((part, side) => ({
      name: `rod ${side}`,
      mesh: rodMesh(side === 0 ? RODS : -RODS),
      color: CREAM,
      casts: false,
      inked: true,
      part,
    })),
  ];
}

/** Two spoked wheels, about the origin. */
export function axleMesh(radius: number): TriangleMesh {
  const wheel = (z: number) => {
    const disc = lathe(
      28,
      [[0, -0.03], [radius + 0.02, -0.03]],
      [[radius + 0.02, -0.03], [radius + 0.02, 0], [radius, 0.01], [radius, 0.045]],
      [[radius, 0.045], [radius * 0.8, 0.045]],
      [[radius * 0.8, 0.045], [radius * 0.76, 0.01]],
      [[radius * 0.76, 0.01], [0, 0.01]],
    ); // prettier-ignore
    const spoke = (angle: number) =>
      placed(roundedBox([radius * 0.78, 0.022, 0.026], 0.012, 3), {
        angles: [0, 0, angle],
        at: [0, 0, z + Math.sign(z) * 0.02],
      });
    const hub = placed(ballMesh(radius * 0.24, 8), { at: [0, 0, z + Math.sign(z) * 0.02] });
    return [
      placed(disc, { at: [0, 0, z], angles: [(Math.sign(z) * Math.PI) / 2, 0, 0] }),
      ...[0, 1, 2].map((third) => spoke((third * Math.PI) / 3)),
      hub,
    ];
  };
  return merged(...wheel(HALF_GAUGE), ...wheel(-HALF_GAUGE));
}

/** The collider. */
export function locomotiveHull(): RigidShape {
  const ahead = [0, 0, Math.SQRT1_2, Math.SQRT1_2] as const;
  return {
    type: 'compound',
    parts: [
      { shape: { type: 'capsule', halfHeight: 0.36, radius: 0.3 }, position: [0.2, 0.58, 0], rotation: ahead },
      { shape: { type: 'cuboid', halfExtents: [0.32, 0.44, 0.36] }, position: [-0.5, 0.66, 0] },
      { shape: { type: 'cylinder', halfHeight: 0.12, radius: 0.12 }, position: [0.44, 0.9, 0] },
    ],
  };
}

function along(mesh: TriangleMesh, y: number, z = 0): TriangleMesh {
  return placed(mesh, { at: [0, y, z], angles: [0, 0, -Math.PI / 2] });
}

function frame(): TriangleMesh {
  const beam = placed(roundedBox([0.05, 0.09, 0.34], 0.04), { at: [0.76, 0.28, 0] });
  const buffer = (z: number) =>
    placed(lathe(14, [[0, 0], [0.035, 0]], [[0.035, 0], [0.035, 0.09]], [[0.035, 0.09], [0.08, 0.1], [0.07, 0.13], [0, 0.14]]), {
      at: [0.79, 0.3, z],
      angles: [0, 0, -Math.PI / 2],
    }); // prettier-ignore
  return merged(
    placed(roundedBox([0.78, 0.05, 0.31], 0.04), { at: [-0.02, 0.34, 0] }),
    beam,
    buffer(0.22),
    buffer(-0.22),
  );
}

function boiler(): TriangleMesh {
  return along(lathe(32, [[0, -0.34], [0.27, -0.34]], [[0.27, -0.34], [0.27, 0.4]], [[0.27, 0.4], [0, 0.4]]), 0.6); // prettier-ignore
}

function hoops(): TriangleMesh {
  const hoop = (x: number) =>
    along(lathe(32, [[0, x], [0.279, x]], [[0.279, x], [0.279, x + 0.045]], [[0.279, x + 0.045], [0, x + 0.045]]), 0.6); // prettier-ignore
  return merged(hoop(-0.12), hoop(0.16));
}

function smokebox(): TriangleMesh {
  const mesh = lathe(32, [[0, 0.28], [0.285, 0.28]], [[0.285, 0.28], [0.29, 0.62]], [[0.29, 0.62], [0.27, 0.68]], [[0.27, 0.68], [0, 0.68]]); // prettier-ignore
  const foot = placed(roundedBox([0.16, 0.14, 0.2], 0.04), { at: [0.46, 0.42, 0] });
  return merged(along(mesh, 0.6), foot);
}

/** The round smokebox door, which has the face. */
function front(): TriangleMesh {
  return along(lathe(32, [[0, 0.66], [0.225, 0.66]], [[0.225, 0.66], [0.23, 0.7], [0.17, 0.735], [0, 0.75]]), 0.6); // prettier-ignore
}

function face(): TriangleMesh {
  const eye = (z: number) => placed(ballMesh(1, 10), { at: [0.735, 0.65, z], scale: [0.03, 0.05, 0.036] });
  const smile = pipe(
    8,
    [[-0.075, 0.02], [-0.045, -0.018], [0, -0.034], [0.045, -0.018], [0.075, 0.02]],
    [[0, 0], [0.012, 0.01]],
    [[0.012, 0.01], [0.019, 0.5], [0.012, 0.99]],
    [[0.012, 0.99], [0, 1]],
  ); // prettier-ignore
  return merged(eye(0.085), eye(-0.085), placed(smile, { at: [0.738, 0.555, 0], angles: [0, Math.PI / 2, 0] }));
}

function cheeks(): TriangleMesh {
  const cheek = (z: number) => placed(ballMesh(1, 8), { at: [0.722, 0.575, z], scale: [0.02, 0.026, 0.042] });
  return merged(cheek(0.145), cheek(-0.145));
}

function chimney(): TriangleMesh {
  return placed(
    lathe(
      24,
      [[0, -0.04], [0.15, -0.04]],
      [[0.15, -0.04], [0.1, 0.05], [0.1, 0.16], [0.15, 0.25]],
      [[0.15, 0.25], [0.1, 0.25]],
      [[0.1, 0.25], [0.08, 0.16]],
      [[0.08, 0.16], [0, 0.16]],
    ),
    { at: [CHIMNEY[0], 0.86, 0] },
  ); // prettier-ignore
}

function rim(): TriangleMesh {
  return placed(
    lathe(
      24,
      [[0, 0.17], [0.13, 0.17]],
      [[0.13, 0.17], [0.17, 0.22], [0.165, 0.265], [0.12, 0.27], [0.095, 0.24]],
      [[0.095, 0.24], [0.085, 0.18]],
      [[0.085, 0.18], [0, 0.18]],
    ),
    { at: [CHIMNEY[0], 0.86, 0] },
  ); // prettier-ignore
}

function dome(): TriangleMesh {
  const outline = [[0.13, 0], [0.1, 0.05], [0.105, 0.12], [0.07, 0.18], [0, 0.2]] as const; // prettier-ignore
  return placed(lathe(24, [[0, 0], [0.13, 0]], outline), { at: [0.08, 0.84, 0] }); // prettier-ignore
}

function cab(): TriangleMesh {
  return placed(roundedBox([0.24, 0.36, 0.31], 0.05), { at: [-0.52, 0.72, 0] });
}

function windows(): TriangleMesh {
  const side = (z: number) => placed(roundedBox([0.12, 0.11, 0.02], [0.06, 0.06, 0.015], 5), { at: [-0.52, 0.84, z] });
  const ahead = (z: number) => placed(roundedBox([0.02, 0.07, 0.06], [0.015, 0.05, 0.05], 5), { at: [-0.28, 0.94, z] });
  return merged(side(0.31), side(-0.31), ahead(0.19), ahead(-0.19));
}

function roof(): TriangleMesh {
  return placed(roundedBox([0.34, 0.07, 0.38], [0.06, 0.07, 0.3]), { at: [-0.53, 1.1, 0] });
}

function cylinders(): TriangleMesh {
  const side = (z: number) =>
    along(lathe(18, [[0, 0.42], [0.1, 0.42]], [[0.1, 0.42], [0.1, 0.66]], [[0.1, 0.66], [0, 0.66]]), 0.24, z); // prettier-ignore
  return merged(side(0.3), side(-0.3));
}

/** The rod that connects the two driven wheels of a side. */
function rodMesh(z: number): TriangleMesh {
  const middle = (AXLES[0] + AXLES[1]) / 2;
  return placed(roundedBox([(AXLES[1] - AXLES[0]) / 2 + 0.05, 0.035, 0.018], 0.018, 5), {
    at: [middle, WHEEL_RADIUS, z],
  });
}
