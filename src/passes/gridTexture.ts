import { DataTexture, FloatType, NearestFilter, RedFormat, Vector2, Vector3, type Texture } from 'three';
import type { FrameView } from '../device/frameView.ts';

/** The grid of src/sim/view.ts, as far as it is looked at. */
export interface GridOfDepths {
  readonly columns: number;
  readonly rows: number;
  /** Cells from one row to the next. */
  readonly stride: number;
  /** Left and low end on the image plane at unit depth, and cells for each of its units. */
  readonly corner: readonly [number, number];
  readonly density: number;
  /** Depths along the eye's forward direction, from the world's origin; infinite where nothing covers. */
  readonly depths: Float32Array;
}

/** Shaders take no infinite numbers for granted. */
const UNCOVERED = 1e30;

/** A grid as a texture of view depths, and where it lies. */
export class GridTexture {
  readonly uniforms = {
    grid: { value: null as Texture | null },
    gridCells: { value: new Vector2() },
    gridPlace: { value: new Vector3() },
  };
  private texture: DataTexture | undefined;

  /** Takes a grid up as it is; without one, nothing is covered. */
  write(eye: FrameView, grid: GridOfDepths | undefined): void {
    this.dispose();
    const { columns, rows, stride, corner, density, depths } = grid ?? EMPTY;
    const eyeDepth = eye.range[0] - eye.uniforms.near.value;
    const values = depths.map((depth) => (depth < UNCOVERED ? depth - eyeDepth : UNCOVERED));
    this.texture = new DataTexture(values, stride, rows, RedFormat, FloatType);
    [this.texture.minFilter, this.texture.magFilter] = [NearestFilter, NearestFilter];
    this.texture.needsUpdate = true;
    this.uniforms.grid.value = this.texture;
    this.uniforms.gridCells.value.set(columns, rows);
    this.uniforms.gridPlace.value.set(...corner, density);
  }

  dispose(): void {
    this.texture?.dispose();
    this.texture = undefined;
  }
}

const EMPTY: GridOfDepths = {
  columns: 0,
  rows: 1,
  stride: 1,
  corner: [0, 0],
  density: 1,
  depths: new Float32Array([Infinity]),
};
