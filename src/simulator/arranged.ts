import type * as Core from './core.ts';
import { ATTRIBUTE_WORDS, PLACE_FLOATS } from './layout.ts';
import type { Rows } from './rows.ts';
import type { CoverageGrid } from './view.ts';

type Triple = [number, number, number];

/** World-space bounding box of the live particles, in metres. All zeros when there are no live particles. */
export interface Bounds {
  readonly min: Readonly<Triple>;
  readonly max: Readonly<Triple>;
  /** Largest radius of a live particle, in metres. */
  readonly greatestRadius: number;
}

/**
 * Result of {@link Simulator.arrange}. Valid until the next call of the simulator: copy what has to last longer.
 */
export interface Arranged {
  readonly rows: Rows;
  /** Bounds of all live particles including their radii, culled or not. */
  readonly bounds: Bounds;
  /** The grid of the occlusion culling; undefined if the view did not ask for any. */
  readonly grid: CoverageGrid | undefined;
}

const BOUNDS_FLOATS = 7;

/** The result of a simulator's last `arrange`, read from WASM memory. It is reused, so that frames leave no garbage. */
export class ArrangedInMemory implements Arranged {
  readonly rows = { count: 0, whole: 0, place: new Float32Array(), attributes: new Uint32Array() };
  readonly bounds = { min: [0, 0, 0] as Triple, max: [0, 0, 0] as Triple, greatestRadius: 0 };
  readonly #handle: Core.Simulator;
  readonly #memory: WebAssembly.Memory;
  #box = new Float32Array();

  constructor(handle: Core.Simulator, memory: WebAssembly.Memory) {
    this.#handle = handle;
    this.#memory = memory;
  }

  /** Reads what the last call has written. @param count number of its rows */
  read(count: number): this {
    // Growing WASM memory replaces its buffer and detaches old views, so each call creates new ones.
    const { buffer } = this.#memory;
    const { rows } = this;
    rows.count = count;
    rows.whole = this.#handle.whole;
    rows.place = new Float32Array(buffer, this.#handle.placePointer, count * PLACE_FLOATS);
    rows.attributes = new Uint32Array(buffer, this.#handle.lookPointer, count * ATTRIBUTE_WORDS);
    this.#readBounds(buffer);
    return this;
  }

  /** Created on demand: only a debug view reads it. */
  get grid(): CoverageGrid | undefined {
    const [columns, rows, stride, left, low, density] = this.#handle.coverageShape;
    if (rows === 0) return undefined;
    const depths = new Float32Array(this.#memory.buffer, this.#handle.coveragePointer, stride * rows);
    return { columns, rows, stride, corner: [left, low], density, depths };
  }

  #readBounds(buffer: ArrayBuffer): void {
    const { boundsPointer } = this.#handle;
    const isMoved = this.#box.buffer !== buffer || this.#box.byteOffset !== boundsPointer;
    if (isMoved) this.#box = new Float32Array(buffer, boundsPointer, BOUNDS_FLOATS);
    const box = this.#box;
    const { min, max } = this.bounds;
    for (let axis = 0; axis < 3; axis++) {
      min[axis] = box[axis];
      max[axis] = box[3 + axis];
    }
    this.bounds.greatestRadius = box[6];
  }
}
