import { VIEW_FLOATS, VIEW_OFFSETS } from './layout.ts';

type Triple = ArrayLike<number>;

/**
 * A view to arrange rows for. Rows are sorted along {@link View.direction}, deterministically: bodies near to far, casters
 * far to near.
 */
export interface View {
  /** `eye` keeps the visible bodies, `light` the casters with visible shadows. */
  purpose: 'eye' | 'light';
  /** Interpolation between the previous step (0) and the latest (1). */
  blend: number;
  /** Whether to cull invisible rows. The image is the same either way. */
  cull: boolean;
  /** Margin for the ink: added to each radius, in world units per unit of clip w. */
  pad: number;
  /** The eye's projection matrix times its view matrix, 16 numbers, column-major. Used for both purposes. */
  clipFromWorld: ArrayLike<number>;
  /**
   * Unit vector in world space: the eye's forward direction, or the direction of light propagation; for a lamp, in the
   * middle of the smoke.
   */
  direction: Triple;
  /** Place of the lamp, metres. Casters are sorted by their distance from it. */
  lamp?: Triple;
  /** Radius of a puff's bounding sphere, in particle radii. */
  reach: number;
  /** Bounding box of all shadow receivers, metres. Casters are swept to where their shadow leaves it. */
  receivers: { min: Triple; max: Triple };
  /** Sides from which each variation is drawn, 1 to 8, default 1. In rows, variation is variation * sides + side. */
  sides?: number;
  /** Share of the roll of puffs that is left out, 0 to 1, default 0. */
  upright?: number;
  /** Enables occlusion culling. If absent, only rows outside the view are culled. */
  coverage?: CoverageView;
}

/** A view that returns all live particles, without culling. */
export const ALL_PARTICLES: Omit<View, 'blend'> = {
  purpose: 'eye',
  cull: false,
  pad: 0,
  clipFromWorld: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
  direction: [0, 0, -1],
  reach: 1,
  receivers: { min: [0, 0, 0], max: [0, 0, 0] },
};

/** Settings of occlusion culling: when a body is certainly hidden, or a caster's shadow certainly redundant. */
export interface CoverageView {
  /** Number of occluders required: 1, or up to 16 if the shadow count matters. 0 disables the culling. */
  covers: number;
  /** Size of a pixel in world units per unit of clip w. */
  pixel: number;
  /** Depths of the near and far plane along the eye's forward direction, relative to the world origin. */
  nearest: number;
  farthest: number;
  /** How much closer to the eye than its lobe a surface may lift a ring of ink, per unit of clip w. */
  lift: number;
  /** World-space boxes of those surfaces, minimum corner then maximum corner; at most `LIFTERS_LIMIT`. */
  lifters: readonly (readonly number[])[];
  /** Minimum and maximum distance behind the centre at which volumes start, in radii, before the nailboard shear. */
  capRange: readonly [number, number];
  /**
   * Start caps by light direction, see src/renderer/puffs/bake/startCaps.ts. If absent, `capRange` applies to all directions.
   */
  startCaps?: { readonly values: Float32Array };
  /** Depth of the deepest visible point of a puff behind the centre plane, in radii. The shear depends on it. */
  depth: number;
  solids: Solids;
}

/** The balls of the puffs, in particle radii; see src/renderer/puffs/bake/solids.ts. */
export interface Solids {
  readonly table: Float32Array;
  /** Balls per variation: 4, 8 or 12. */
  readonly balls: number;
  readonly facesEye: 0 | 1 | 2;
  readonly tolerance: number;
  readonly blur: number;
}

/**
 * The grid for occlusion culling. Its plane is the eye's image plane at unit depth, with x to the right and y up from
 * the view axis, or a plane perpendicular to the light.
 */
export interface CoverageGrid {
  readonly columns: number;
  readonly rows: number;
  /** Offset from one row to the next, in cells. */
  readonly stride: number;
  /** Left and bottom edge on that plane; `density` is the number of cells per unit. */
  readonly corner: readonly [number, number];
  readonly density: number;
  /** Per cell, the depth along the view beyond which everything is hidden, in metres; Infinity if uncovered. */
  readonly depths: Float32Array;
}

/** Number of floats of a packed `view`, including solids and start caps. */
export function viewLength({ coverage }: View): number {
  return VIEW_FLOATS + (coverage ? coverage.solids.table.length + (coverage.startCaps?.values.length ?? 0) : 0);
}

/**
 * Packs `view` into `target`.
 *
 * @param target {@link viewLength} floats, fully overwritten.
 */
export function writeView(view: View, target: Float32Array): void {
  target.fill(0);
  const light = view.lamp ? 2 : 1;
  target[VIEW_OFFSETS.purpose] = view.purpose === 'light' ? light : 0;
  target.set(view.lamp ?? [], VIEW_OFFSETS.lamp);
  target[VIEW_OFFSETS.blend] = view.blend;
  target[VIEW_OFFSETS.cull] = view.cull ? 1 : 0;
  target[VIEW_OFFSETS.pad] = view.pad;
  copy(view.clipFromWorld, target, VIEW_OFFSETS.clipFromWorld, 16);
  copy(view.direction, target, VIEW_OFFSETS.direction, 3);
  target[VIEW_OFFSETS.reach] = view.reach;
  target[VIEW_OFFSETS.sides] = view.sides ?? 1;
  target[VIEW_OFFSETS.upright] = view.upright ?? 0;
  copy(view.receivers.min, target, VIEW_OFFSETS.receivers, 3);
  copy(view.receivers.max, target, VIEW_OFFSETS.receivers + 3, 3);
  if (view.coverage) writeCoverage(view.coverage, target);
}

function writeCoverage(coverage: CoverageView, target: Float32Array): void {
  const { solids } = coverage;
  for (const name of ['pixel', 'nearest', 'farthest', 'covers', 'lift', 'depth'] as const) {
    target[VIEW_OFFSETS[name]] = coverage[name];
  }
  target[VIEW_OFFSETS.tolerance] = solids.tolerance;
  target[VIEW_OFFSETS.blur] = solids.blur;
  target[VIEW_OFFSETS.facesEye] = solids.facesEye;
  copy(coverage.capRange, target, VIEW_OFFSETS.capRange, 2);
  target[VIEW_OFFSETS.balls] = solids.balls;
  target[VIEW_OFFSETS.lifters] = coverage.lifters.length;
  coverage.lifters.forEach((box, index) => copy(box, target, VIEW_OFFSETS.lifterBoxes + 6 * index, 6));
  target.set(solids.table, VIEW_FLOATS);
  target[VIEW_OFFSETS.capsFollow] = coverage.startCaps ? 1 : 0;
  if (coverage.startCaps) target.set(coverage.startCaps.values, VIEW_FLOATS + solids.table.length);
}

function copy(from: ArrayLike<number>, to: Float32Array, offset: number, count: number): void {
  for (let index = 0; index < count; index++) to[offset + index] = from[index];
}
