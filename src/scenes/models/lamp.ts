/**
 * A magic oil lamp, about 1.85 m from handle to lip, that stands on y = 0 with its spout towards +x. Plain data: every
 * part is closed and wound anticlockwise from outside, so that it can throw a shadow volume.
 */
import type { TriangleMesh } from '../../passes/extrusion.ts';
import type { RigidShape } from '../../sim/rigid.ts';
import { BELLY, COLLAR, CURL, FOOT, GEM, HANDLE, LID, OPENING, SPOUT, SPOUT_PATH } from './lampShape.ts';
import { circle, planarAxis, revolve, type SurfaceOfRevolution } from './revolve.ts';

type Vector = readonly [x: number, y: number, z: number];

/** Which of the lamp's colours a part takes: the polished metal, its darker fittings, the gem on the lid. */
export type LampRole = 'metal' | 'fitting' | 'gem';

/** A closed mesh of the lamp. Parts reach into each other. */
export interface LampPart {
  readonly name: string;
  readonly role: LampRole;
  readonly mesh: TriangleMesh;
}

/** Where smoke leaves the lamp; metres. */
export interface LampSpout {
  /** Middle of the mouth. */
  readonly position: Vector;
  /** Unit vector out of the mouth. */
  readonly direction: Vector;
  /** Of the opening. */
  readonly radius: number;
}

export interface LampModel {
  readonly parts: readonly LampPart[];
  readonly spout: LampSpout;
  /**
   * A few coarse pieces in the lamp's own space, for fixed rigids at the lamp's place. They are closed, and leave the
   * spout's mouth and the loop of the handle open.
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

/** Shares of the spout's outer wall between which it is one piece; the last stays below the bottom of the mouth. */
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

/** Points round a stretch of a turning at a share of its length; one where it meets the axis. */
function ring(surface: SurfaceOfRevolution, stretch: number, share: number, corners: number): (readonly number[])[] {
  const { curve } = surface.profile[stretch];
  const count = curve(share)[0] === 0 ? 1 : corners;
  const pointAt = circle(surface, curve, share);
  return Array.from({ length: count }, (_, i) => pointAt((2 * Math.PI * i) / corners));
}

function hull(points: readonly (readonly number[])[]): RigidShape {
  return { type: 'convexHull', vertices: points.flat() };
}

/** A bent part as triangles: hulls of so thin a loop would have to be many. */
function coarse(surface: SurfaceOfRevolution): RigidShape {
  const profile = surface.profile.map(({ curve, bands }) => ({ curve, bands: Math.ceil(bands / 3) }));
  const { positions, indices } = revolve({ ...surface, profile, segments: 6 });
  return { type: 'trimesh', vertices: positions, indices };
}
