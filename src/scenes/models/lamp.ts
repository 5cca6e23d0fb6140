/**
 * A magic oil lamp, about 1.85 m from handle to lip, that stands on y = 0 with its spout towards +x. Plain data: every
 * part is closed and wound anticlockwise seen from outside, so that it can cast a shadow volume.
 */
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import type { RigidShape } from '../../simulator/rigid.ts';
import { BELLY, COLLAR, CURL, FOOT, GEM, HANDLE, LID, OPENING, SPOUT, SPOUT_PATH } from './lampShape.ts';
import { circle, planarAxis, revolve, type SurfaceOfRevolution } from './revolve.ts';

type Vector = readonly [x: number, y: number, z: number];

/** The colour role of a part: the polished metal, the darker fittings, the gem on the lid. */
export type LampRole = 'metal' | 'fitting' | 'gem';

/** A closed mesh of the lamp. Parts may intersect. */
export interface LampPart {
  readonly name: string;
  readonly role: LampRole;
  readonly mesh: TriangleMesh;
}

/** The opening that emits smoke; metres. */
export interface LampSpout {
  /** Centre of the opening. */
  readonly position: Vector;
  /** Unit vector out of the opening. */
  readonly direction: Vector;
  /** Radius of the opening. */
  readonly radius: number;
}

export interface LampModel {
  readonly parts: readonly LampPart[];
  readonly spout: LampSpout;
  /**
   * A few coarse colliders in the lamp's local space, for fixed rigids at the lamp's position. They are closed, and
   * leave the opening of the spout and the loop of the handle free.
   */
  readonly collision: readonly RigidShape[];
}

/** Builds the lamp: about 6,000 triangles. */
export function lampModel(): LampModel {
  return {
    parts: [
      { name: 'foot', role: 'fitting', mesh: revolve(FOOT) },
      { name: 'belly', role: 'metal', mesh: revolve(BELLY) },
      { name: 'collar', role: 'fitting', mesh: revolve(COLLAR) },
      { name: 'lid', role: 'metal', mesh: revolve(LID) },
      { name: 'gem', role: 'gem', mesh: revolve(GEM) },
      { name: 'spout', role: 'metal', mesh: revolve(SPOUT) },
      { name: 'handle', role: 'fitting', mesh: revolve(HANDLE) },
      { name: 'curl', role: 'fitting', mesh: revolve(CURL) },
    ],
    spout: spoutMouth(),
    collision: collisionPieces(),
  };
}

function spoutMouth(): LampSpout {
  const { origin, across } = planarAxis(SPOUT_PATH)(1);
  return { position: origin, direction: [across[1], -across[0], 0], radius: OPENING };
}

/**
 * Fractions of the spout's outer wall at which the collider is split; the last one is below the bottom of the opening.
 */
const SPOUT_CUTS = [0, 1 / 7, 2 / 7, 3 / 7, 4 / 7, 5 / 7, 6 / 7];

function collisionPieces(): RigidShape[] {
  return [
    hull([...ring(FOOT, 1, 0, 12), ...ring(FOOT, 1, 0.5, 12), ...ring(FOOT, 3, 0.5, 12)]),
    hull([0.1, 0.3, 0.45, 0.6, 0.8, 1].flatMap((share) => ring(BELLY, 0, share, 16))),
    hull([...ring(COLLAR, 1, 0.5, 12), ...[0, 0.4, 0.8, 1].flatMap((share) => ring(LID, 1, share, 12))]),
    hull([0, 0.2, 0.4, 0.7, 1].flatMap((share) => ring(GEM, 0, share, 8))),
    ...SPOUT_CUTS.slice(1).map((cut, i) => hull([...ring(SPOUT, 1, SPOUT_CUTS[i], 8), ...ring(SPOUT, 1, cut, 8)])),
    coarse(HANDLE),
    coarse(CURL),
  ];
}

/** Points around a profile stretch at a fraction of its length; a single point where it meets the axis. */
function ring(surface: SurfaceOfRevolution, stretch: number, share: number, corners: number): (readonly number[])[] {
  const { curve } = surface.profile[stretch];
  const count = curve(share)[0] === 0 ? 1 : corners;
  const pointAt = circle(surface, curve, share);
  return Array.from({ length: count }, (_, i) => pointAt((2 * Math.PI * i) / corners));
}

function hull(points: readonly (readonly number[])[]): RigidShape {
  return { type: 'convexHull', vertices: points.flat() };
}

/** A curved part as a triangle mesh: convex hulls of so thin a loop would require many pieces. */
function coarse(surface: SurfaceOfRevolution): RigidShape {
  const profile = surface.profile.map(({ curve, bands }) => ({ curve, bands: Math.ceil(bands / 3) }));
  const { positions, indices } = revolve({ ...surface, profile, segments: 6 });
  return { type: 'trimesh', vertices: positions, indices };
}
