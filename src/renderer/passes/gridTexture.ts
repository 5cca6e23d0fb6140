import { DataTexture, FloatType, NearestFilter, RedFormat, Vector2, Vector3, type Texture } from 'three';
import type { FrameView } from '../gpu/frameView.ts';

/** The fields of the grid of src/simulator/view.ts that the debug view reads. */
export interface GridOfDepths {
  readonly columns: number;
  readonly rows: number;
  /** Distance between rows, in cells. */
  readonly stride: number;
  /** Lower left corner on the image plane at unit depth, and cells for each unit of that plane. */
  readonly corner: readonly [number, number];
  readonly density: number;
  /** Depths along the camera's forward direction, measured from the world origin; Infinity for uncovered cells. */
  readonly depths: Float32Array;
}

/** Stands in for Infinity, because GLSL implementations need not support infinite values. */
const UNCOVERED = 1e30;

/** A grid as a texture of view depths, with its placement on the image plane. */
export class GridTexture {
  readonly uniforms = {
    grid: { value: null as Texture | null },
    gridCells: { value: new Vector2() },
    gridPlace: { value: new Vector3() },
  };
  private texture: DataTexture | undefined;

  /** Uploads a grid. Without one, no cell is covered. */
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
