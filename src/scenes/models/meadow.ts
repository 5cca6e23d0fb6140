/** A meadow under the sky: hills, a windmill, sheep, and a sun with a face. */
import type { Color } from '../../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import { cos, sin } from '../../simulator/exact/sine.ts';
import type { Vector } from '../scene.ts';
import { ballMesh } from './ball.ts';
import { friendlyFace } from './face.ts';
import { lathe } from './lathe.ts';
import { merged, placed } from './place.ts';
import { roundedBox } from './roundedBox.ts';

const CREAM: Color = [252, 236, 206];
const RED: Color = [226, 92, 74];
const WOOD: Color = [150, 100, 80];
const WOOL: Color = [255, 250, 238];
const DARK: Color = [74, 56, 72];
const GOLD: Color = [255, 206, 84];
const GLOW: Color = [255, 170, 74];

/** Axis of the windmill's sails. */
export const AXLE: Vector = [-2.05, 0.22, 0.42];
const MILL: Vector = [-2.05, -0.98, 0];
/** Normal of the sun's bright side: towards the light, and slightly to the front. */
const SHINING: Vector = [0.8, 0, 0.6];
/** Radius of the sun's face. */
const SUN = 0.52;

export function hills(): SurfaceDescription[] {
  const hill = (at: Vector, scale: Vector) => placed(ballMesh(1, 32), { at, scale });
  const look = { casts: false, inked: true };
  return [
    {
      name: 'far hills',
      mesh: merged(hill([-4.6, -3.2, -3.4], [5.2, 2.5, 2.4]), hill([4.4, -3.3, -3.4], [5.6, 2.9, 2.4])),
      color: [128, 190, 148],
      ...look,
    },
    { name: 'meadow', mesh: hill([0, -4.6, 0.6], [9.5, 3.75, 4.2]), color: [152, 204, 104], ...look },
    { name: 'near hill', mesh: hill([4.6, -4.4, 3.2], [5.4, 3.1, 2.4]), color: [120, 182, 92], ...look },
  ];
}

/** @param sails index of the part for the sails */
export function windmill(sails: number): SurfaceDescription[] {
  const look = { casts: true, inked: true };
  const [x, y, z] = MILL;
  const at = { at: MILL };
  const tower = lathe(24, [[0, -0.2], [0.46, -0.2]], [[0.46, -0.2], [0.4, 0.3], [0.3, 0.95]], [[0.3, 0.95], [0, 0.95]]); // prettier-ignore
  const roof = lathe(24, [[0, 0.92], [0.38, 0.92]], [[0.38, 0.92], [0.3, 1.18], [0.16, 1.4], [0, 1.48]]); // prettier-ignore
  const face = friendlyFace(0.46, 0.36);
  const door = placed(roundedBox([0.12, 0.2, 0.06], [0.1, 0.14, 0.04]), { at: [x, y + 0.14, z + 0.4] });
  return [
    { name: 'tower', mesh: placed(tower, at), color: CREAM, ...look },
    { name: 'roof', mesh: placed(roof, at), color: RED, ...look },
    { name: 'door', mesh: door, color: WOOD, ...look, casts: false },
    {
      name: 'mill eyes',
      mesh: placed(face.features, { at: [x, y + 0.62, z + 0.35] }),
      color: DARK,
      casts: false,
      inked: false,
    },
    {
      name: 'mill cheeks',
      mesh: placed(face.cheeks, { at: [x, y + 0.62, z + 0.35] }),
      color: [244, 158, 138],
      casts: false,
      inked: false,
    },
    { name: 'spars', mesh: merged(...[0, 1, 2, 3].map(spar)), color: WOOD, ...look, part: sails, group: 'sails' },
    { name: 'sails', mesh: merged(...[0, 1, 2, 3].map(sail)), color: WOOL, ...look, part: sails, group: 'sails' },
    { name: 'hub', mesh: placed(ballMesh(0.1, 10), { at: [0, 0, 0.04] }), color: RED, ...look, part: sails },
  ];
}

function spar(quarter: number): TriangleMesh {
  return placed(placed(roundedBox([0.03, 0.46, 0.025], 0.02, 5), { at: [0, 0.46, 0] }), rotated(quarter));
}

function sail(quarter: number): TriangleMesh {
  return placed(placed(roundedBox([0.12, 0.33, 0.02], 0.02, 5), { at: [0.1, 0.55, 0.05] }), rotated(quarter));
}

function rotated(quarter: number): { angles: Vector } {
  return { angles: [0, 0, (quarter * Math.PI) / 2] };
}

/** Grazing sheep, each facing left or right. */
export function sheep(stands: readonly (readonly [at: Vector, side: 1 | -1])[]): SurfaceDescription[] {
  const each = (make: (side: 1 | -1) => TriangleMesh) =>
    merged(...stands.map(([at, side]) => placed(make(side), { at, angles: [0, side > 0 ? 0.35 : -0.35, 0] })));
  return [
    { name: 'wool', mesh: each(wool), color: WOOL, casts: true, inked: true },
    { name: 'heads', mesh: each(headAndLegs), color: DARK, casts: true, inked: true },
  ];
}

function wool(): TriangleMesh {
  const tuft = (x: number, y: number, z: number, radius: number) => placed(ballMesh(radius, 10), { at: [x, y, z] });
  return merged(
    tuft(0, 0.3, 0, 0.17),
    tuft(0.14, 0.32, 0.03, 0.13),
    tuft(-0.14, 0.3, 0.02, 0.14),
    tuft(0.05, 0.4, 0, 0.12),
    tuft(-0.07, 0.39, 0.03, 0.12),
    tuft(0.02, 0.27, 0.1, 0.12),
  );
}

function headAndLegs(side: 1 | -1): TriangleMesh {
  const leg = (x: number, z: number) => placed(roundedBox([0.028, 0.1, 0.028], 0.02, 5), { at: [x, 0.1, z] });
  const ear = (z: number) => placed(ballMesh(1, 8), { at: [side * 0.26, 0.4, z], scale: [0.035, 0.03, 0.06] });
  return merged(
    placed(ballMesh(1, 12), { at: [side * 0.29, 0.33, 0.04], scale: [0.1, 0.085, 0.075], angles: [0, 0, -side * 0.5] }),
    ear(0.12),
    ear(-0.04),
    leg(0.1, 0.06),
    leg(-0.1, 0.06),
    leg(0.1, -0.06),
    leg(-0.1, -0.06),
  );
}

/**
 * A disc with rays and a face.
 * @param rays index of the rotating part, whose bright side is its own +x
 * @param face index of the part that stays upright
 */
export function sun(rays: number, face: number): SurfaceDescription[] {
  const disc = placed(ballMesh(1, 24), { scale: [SUN, SUN, 0.2] });
  const { features, cheeks } = friendlyFace(0.6, 4);
  const all = merged(...Array.from({ length: 12 }, (_, index) => ray(index)));
  const look = { casts: false, inked: true, glows: true };
  const plain = { casts: false, inked: false, part: face };
  const bright = { part: rays, glows: true };
  return [
    { name: 'rays', mesh: all, color: GLOW, ...look, part: rays },
    { name: 'disc', mesh: disc, color: GOLD, ...look, part: rays },
    { name: 'glow', mesh: shining(all), color: GLOW, ...plain, ...bright },
    { name: 'sun', mesh: shining(disc), color: GOLD, ...plain, ...bright },
    { name: 'sun eyes', mesh: placed(features, { at: [0, 0, 0.225] }), color: [140, 70, 50], ...plain },
    { name: 'sun cheeks', mesh: shining(placed(cheeks, { at: [0, 0, 0.19] })), color: GLOW, ...plain, glows: true },
  ];
}

function ray(index: number): TriangleMesh {
  const angle = (2 * Math.PI * index) / 12;
  const out = SUN + 0.05;
  const cone = lathe(10, [[0, 0], [0.13, 0]], [[0.13, 0], [0, index % 2 === 0 ? 0.34 : 0.22]]); // prettier-ignore
  return placed(cone, { at: [-sin(angle) * out, cos(angle) * out, -0.02], angles: [0, 0, angle] });
}

/** A light source has no dark side: a cover mesh whose normals all point towards the light. */
function shining(mesh: TriangleMesh): TriangleMesh {
  const raised = mesh.positions.map((at, i) => (i % 3 === 2 ? at + 0.015 : at));
  return { ...mesh, positions: raised, normals: raised.map((_, i) => SHINING[i % 3]) };
}
