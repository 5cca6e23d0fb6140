import { DataTexture, FloatType, RGBAFormat, type Matrix4 } from 'three';

/** World transforms of surfaces for vertex shaders, see shaders/lib/transforms.glsl: one row of four texels for each. */
export class TransformTexture {
  readonly texture: DataTexture;
  private readonly elements: Float32Array;

  /** @param count number of surfaces, at most the maximum height of a texture */
  constructor(count: number) {
    this.elements = new Float32Array(16 * Math.max(1, count));
    for (let first = 0; first < this.elements.length; first += 16) this.elements.set(IDENTITY, first);
    this.texture = new DataTexture(this.elements, 4, Math.max(1, count), RGBAFormat, FloatType);
    this.texture.needsUpdate = true;
  }

  set(surface: number, worldFromModel: Matrix4): void {
    this.elements.set(worldFromModel.elements, 16 * surface);
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture.dispose();
  }
}

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
