/** The colours of a mesh: those of its vertices times its texture, both in sRGB as an artist paints them. */
import type { PixelImage, PuffMesh } from '../shapes.ts';

/** Weights of the three corners of a triangle, of any sum. */
type Weights = readonly [number, number, number];

/** Reads the colours of a mesh. */
export class Paint {
  private readonly mesh: PuffMesh;
  private readonly texel: [number, number, number] = [1, 1, 1];

  private constructor(mesh: PuffMesh) {
    this.mesh = mesh;
  }

  /** Undefined if the whole mesh is white. */
  static of(mesh: PuffMesh): Paint | undefined {
    const { colors, uvs, texture } = mesh;
    return colors || (uvs && texture) ? new Paint(mesh) : undefined;
  }

  /**
   * Adds the red, green and blue of a place, 0..1, to `sum`.
   * @param triangle position of the triangle in the mesh's `indices`
   */
  add(triangle: number, weights: Weights, sum: Float32Array): void {
    const { colors, uvs, texture } = this.mesh;
    if (uvs && texture) {
      const [u, v] = [0, 1].map((at) => this.mean(uvs, 2, at, triangle, weights));
      readImage(texture, u, v, this.texel);
    }
    for (let channel = 0; channel < 3; channel++) {
      sum[channel] += this.texel[channel] * (colors ? this.mean(colors, 3, channel, triangle, weights) : 1);
    }
  }

  private mean(values: Float32Array, stride: number, at: number, triangle: number, [a, b, c]: Weights): number {
    const { indices } = this.mesh;
    const first = values[stride * indices[triangle] + at];
    const second = values[stride * indices[triangle + 1] + at];
    const third = values[stride * indices[triangle + 2] + at];
    return (a * first + b * second + c * third) / (a + b + c);
  }
}

/** Reads a repeating image with linear filtering. */
function readImage({ width, height, data }: PixelImage, u: number, v: number, color: number[]): void {
  const x = (u - Math.floor(u)) * width - 0.5;
  const y = (v - Math.floor(v)) * height - 0.5;
  const [left, top] = [Math.floor(x), Math.floor(y)];
  const [right, down] = [x - left, y - top];
  const [upper, lower] = [((top + height) % height) * width, ((top + 1) % height) * width];
  const [west, east] = [(left + width) % width, (left + 1) % width];
  for (let channel = 0; channel < 3; channel++) {
    const read = (row: number): number =>
      data[4 * (row + west) + channel] * (1 - right) + data[4 * (row + east) + channel] * right;
    color[channel] = (read(upper) * (1 - down) + read(lower) * down) / 255;
  }
}
