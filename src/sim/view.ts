/**
 * What the simulator is asked to arrange its rows for, and the floats in which that crosses into WASM: these, then the
 * solids, then the start caps.
 */
export const VIEW_FLOATS = 92;

/** Offsets into the floats of a view; `tests/unit/simLayout.test.ts` compares them with what Rust reads. */
export const VIEW_OFFSETS = {
  purpose: 0,
  blend: 1,
  cull: 2,
  pad: 3,
  clipFromWorld: 4,
  direction: 20,
  reach: 23,
  receivers: 24,
  pixel: 30,
  nearest: 31,
  farthest: 32,
  covers: 33,
  tolerance: 34,
  blur: 35,
  facesEye: 36,
  lift: 37,
  capRange: 38,
  depth: 40,
  balls: 41,
  lifters: 42,
  lifterBoxes: 43,
  capsFollow: 91,
} as const;

/** Most boxes of {@link CoverageView.lifters}. */
export const LIFTERS_LIMIT = 8;

type Triple = ArrayLike<number>;

/** Rows come near to far along {@link View.direction}, in the same order whenever the particles are the same. */
export interface View {
  /** `eye`: the bodies that can be seen. `light`: the casters whose shadow can be seen. */
  purpose: 'eye' | 'light';
  /** Where between the previous step (0) and now (1) the particles are shown. */
  blend: number;
  /** Leave out what cannot show; the picture is the same either way. */
  cull: boolean;
  /** Added to each radius for each unit of clip w, world units; room for the ink. */
  pad: number;
  /** The eye's projection times view matrix, 16 numbers, column-major; for both purposes. */
  clipFromWorld: ArrayLike<number>;
  /** Unit vector in world space: the eye's forward direction, or the direction in which light travels. */
  direction: Triple;
  /** Factor on the radius that makes the sphere which holds all of a puff. */
  reach: number;
  /** The box that holds everything that can receive a shadow, metres; casters are swept to its exit. */
  receivers: { min: Triple; max: Triple };
  /** What rows may hide of each other; where absent, only what lies beside the view is left out. */
  coverage?: CoverageView;
}

/** A view of everything that lives, from nowhere: what it hides or where it lies plays no part. */
export const ALL_THAT_LIVES: Omit<View, 'blend'> = {
  purpose: 'eye',
  cull: false,
  pad: 0,
  clipFromWorld: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
  direction: [0, 0, -1],
  reach: 1,
  receivers: { min: [0, 0, 0], max: [0, 0, 0] },
};

/** By what it is certain that a body is hidden, or that a caster's shadow is there already. */
export interface CoverageView {
  /** How many covers make certain: 1, or up to 16 where counts matter; 0 leaves nothing out. */
  covers: number;
  /** World units that a pixel spans for each unit of clip w. */
  pixel: number;
  /** Depths along the eye's forward direction at its near and far plane, from the world's origin. */
  nearest: number;
  farthest: number;
  /** How much nearer than its lobe a ring of ink may come, for each unit of clip w, where a surface lifts it. */
  lift: number;
  /** World boxes that hold those surfaces, least corner and greatest; at most {@link LIFTERS_LIMIT}. */
  lifters: readonly (readonly number[])[];
  /** Radii behind the centre at which volumes start, at least and at most, before the shear of nailboards moves it. */
  capRange: readonly [number, number];
  /** The same by the direction of the light, as src/puffs/bake/startCaps.ts tabulates it; where absent, the range holds for all. */
  startCaps?: { readonly values: Float32Array };
  /** Radii behind the centre plane that a puff can be seen at; the shear depends on it. */
  depth: number;
  solids: Solids;
}

/** The balls that puffs consist of, in their radii; see src/puffs/bake/solids.ts. */
export interface Solids {
  readonly table: Float32Array;
  /** 4, 8 or 12. */
  readonly balls: number;
  readonly facesEye: boolean;
  readonly tolerance: number;
  readonly blur: number;
}

/**
 * The grid that rows are laid out on to find what they cover. Its plane is the eye's image plane at unit depth, to the
 * right and up from the view's axis, or a plane across the light.
 */
export interface CoverageGrid {
  readonly columns: number;
  readonly rows: number;
  /** Cells from one row to the next. */
  readonly stride: number;
  /** Left and low end on that plane, and cells for each of its units. */
  readonly corner: readonly [number, number];
  readonly density: number;
  /** Depths along the view, metres, behind which nothing shows in a cell; infinite where nothing covers. */
  readonly depths: Float32Array;
}

/** Floats that `view` takes, solids and start caps included. */
export function viewLength({ coverage }: View): number {
  return VIEW_FLOATS + (coverage ? coverage.solids.table.length + (coverage.startCaps?.values.length ?? 0) : 0);
}

/**
 * Writes `view` into `target`.
 *
 * @param target {@link viewLength} floats, overwritten whole.
 */
export function writeView(view: View, target: Float32Array): void {
  target.fill(0);
  target[VIEW_OFFSETS.purpose] = view.purpose === 'light' ? 1 : 0;
  target[VIEW_OFFSETS.blend] = view.blend;
  target[VIEW_OFFSETS.cull] = view.cull ? 1 : 0;
  target[VIEW_OFFSETS.pad] = view.pad;
  copy(view.clipFromWorld, target, VIEW_OFFSETS.clipFromWorld, 16);
  copy(view.direction, target, VIEW_OFFSETS.direction, 3);
  target[VIEW_OFFSETS.reach] = view.reach;
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
  target[VIEW_OFFSETS.facesEye] = solids.facesEye ? 1 : 0;
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
