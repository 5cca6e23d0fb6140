import { DataTexture, FloatType, Matrix4, RGBAFormat } from 'three';

/** Where the surfaces of a scene are, and the rows of its skin, which follow them. The shaders of all passes read it from one texture. */
export class SurfaceTransforms {
  /** World transforms, one row of four texels for each surface; all zeros for an invisible one. */
  readonly texture: DataTexture;
  /** Counts the surfaces that appeared or disappeared. */
  changes = 0;
  private readonly elements: Float32Array;
  private readonly matrices: readonly Matrix4[];
  private readonly visible: boolean[];

  /** @param count number of surfaces and rows of the skin, at most the maximum height of a texture; they start at the identity */
  constructor(count: number) {
    this.matrices = Array.from({ length: count }, () => new Matrix4());
    this.visible = this.matrices.map(() => true);
    this.elements = new Float32Array(16 * Math.max(1, count));
    this.texture = new DataTexture(this.elements, 4, Math.max(1, count), RGBAFormat, FloatType);
    this.matrices.forEach((_, surface) => this.write(surface));
  }

  /** Sets the world transform and the visibility of a surface. */
  place(surface: number, worldFromModel: Matrix4, isVisible = true): void {
    if (this.visible[surface] === isVisible && this.matrices[surface].equals(worldFromModel)) return;
    this.matrices[surface].copy(worldFromModel);
    if (this.visible[surface] !== isVisible) this.changes++;
    this.visible[surface] = isVisible;
    this.write(surface);
  }

  /** Sets the transforms of rows, from the first one on. @param matrices column-major */
  placeRows(first: number, matrices: Float32Array): void {
    this.elements.set(matrices, 16 * first);
    this.texture.needsUpdate = true;
  }

  worldFromModel(surface: number): Matrix4 {
    return this.matrices[surface];
  }

  isVisible(surface: number): boolean {
    return this.visible[surface];
  }

  dispose(): void {
    this.texture.dispose();
  }

  private write(surface: number): void {
    const first = 16 * surface;
    if (this.visible[surface]) this.elements.set(this.matrices[surface].elements, first);
    else this.elements.fill(0, first, first + 16);
    this.texture.needsUpdate = true;
  }
}
