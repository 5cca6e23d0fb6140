/**
 * What the simulator is asked to arrange its rows for, and the 32 floats in which that crosses into WASM.
 */
export const VIEW_FLOATS = 32;

/** Offsets into the floats of a view; `tests/unit/simView.test.ts` compares them with what the WASM reports. */
export const VIEW_OFFSETS = {
  purpose: 0,
  blend: 1,
  cull: 2,
  pad: 3,
  clipFromWorld: 4,
  direction: 20,
  reach: 23,
  receivers: 24,
} as const;

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
}

/**
 * Writes `view` into `target`.
 *
 * @param target {@link VIEW_FLOATS} floats, overwritten whole.
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
}

function copy(from: ArrayLike<number>, to: Float32Array, offset: number, count: number): void {
  for (let index = 0; index < count; index++) to[offset + index] = from[index];
}
