import { ClampToEdgeWrapping, Data3DTexture, LinearFilter, Matrix4, NoColorSpace, Vector3 } from 'three';

/** Places and radii of all particles: four floats for each. */
export interface Particles {
  readonly count: number;
  readonly place: Float32Array;
}

/** Cells along each axis. */
const CELLS = 32;
/** Least size of a cell in mean radii of particles. */
const CELL = 0.75;
/** Half of the grid in standard deviations of the places, and in mean radii. */
const [SPREAD, MARGIN] = [2.2, 3];
/** How often the density is smoothed. Each time adds half of a squared cell to the variance. */
const ROUNDS = 2;
/** Length of a vector for a density that changes by its own amount within a cell. */
const SLOPE = 1.5;
/** Density, in that of a mean particle in one cell, below which a form fades. */
const FAINT = 0.05;
/** Cells at the border of the grid without particles, and the next ones, in which particles fade. */
const [EMPTY, FADING] = [3, 2];
/** Steps of a component of a vector. */
const STEPS = 127;
const [ROW, LAYER] = [CELLS, CELLS * CELLS];
const STRIDES = [1, ROW, LAYER];

/**
 * Which way the outside of the whole smoke faces at each place: the direction in which the density of particles falls, as a
 * texture. It depends only on the particles, and continuously: the grid has its middle at their centre of mass, its size
 * follows from their spread, and each particle counts by its volume, so that births and deaths change little.
 */
export class PlumeForm {
  /** Vectors of length 0 to 1: 0 where the density is even or where there is no smoke. See simplify/tones.frag. */
  readonly texture = new Data3DTexture(new Uint8Array(4 * CELLS ** 3), CELLS, CELLS, CELLS);
  /** From world space to coordinates of the texture. */
  readonly fromWorld = new Matrix4();
  private readonly corner = new Vector3();
  private cell = 1;
  private density = new Float32Array(CELLS ** 3);
  private smoothed = new Float32Array(CELLS ** 3);

  constructor() {
    (this.texture.image.data as Uint8Array).fill(STEPS + 1);
    this.texture.colorSpace = NoColorSpace;
    this.texture.minFilter = this.texture.magFilter = LinearFilter;
    this.texture.wrapR = this.texture.wrapS = this.texture.wrapT = ClampToEdgeWrapping;
  }

  /** Takes the form of these particles. */
  follow(particles: Particles): void {
    const radius = this.place(particles);
    this.density.fill(0);
    for (let particle = 0; particle < particles.count; particle++) this.add(particles.place, 4 * particle);
    for (let round = 0; round < ROUNDS; round++) for (const stride of STRIDES) this.smooth(stride);
    this.write(FAINT * radius ** 3);
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture.dispose();
  }

  /** Places the grid, and returns the mean radius. */
  private place({ count, place }: Particles): number {
    const [sum, squares] = [new Vector3(), new Vector3()];
    let [mass, radii] = [0, 0];
    const at = new Vector3();
    for (let particle = 0; particle < count; particle++) {
      const radius = place[4 * particle + 3];
      const volume = radius ** 3;
      at.fromArray(place, 4 * particle);
      mass += volume;
      radii += volume * radius;
      sum.addScaledVector(at, volume);
      squares.addScaledVector(at.multiply(at), volume);
    }
    mass ||= 1;
    const mean = sum.divideScalar(mass);
    const spread = (axis: 'x' | 'y' | 'z') => Math.sqrt(Math.max(0, squares[axis] / mass - mean[axis] ** 2));
    const radius = radii / mass || 1;
    const half = SPREAD * Math.max(spread('x'), spread('y'), spread('z')) + MARGIN * radius;
    this.cell = Math.max(CELL * radius, (2 * half) / (CELLS - 1));
    this.corner.copy(mean).subScalar(0.5 * CELLS * this.cell);
    const scale = 1 / (CELLS * this.cell);
    this.fromWorld.makeScale(scale, scale, scale).setPosition(this.corner.clone().multiplyScalar(-scale));
    return radius;
  }

  /** Spreads the volume of a particle over 27 cells, by quadratic B-splines. */
  private add(place: Float32Array, at: number): void {
    const { density, corner, cell } = this;
    const [x, y, z] = [
      (place[at] - corner.x) / cell,
      (place[at + 1] - corner.y) / cell,
      (place[at + 2] - corner.z) / cell,
    ];
    const fade = (Math.min(x, y, z, CELLS - x, CELLS - y, CELLS - z) - EMPTY) / FADING;
    if (fade <= 0) return;
    const volume = Math.min(1, fade) * place[at + 3] ** 3;
    const [column, row, layer] = [Math.floor(x), Math.floor(y), Math.floor(z)];
    for (let k = -1; k < 2; k++) {
      const share = volume * spline(z - layer - k - 0.5);
      for (let j = -1; j < 2; j++) {
        const part = share * spline(y - row - j - 0.5);
        const first = (layer + k) * LAYER + (row + j) * ROW + column;
        for (let i = -1; i < 2; i++) density[first + i] += part * spline(x - column - i - 0.5);
      }
    }
  }

  /** Averages neighbours along an axis, 1 : 2 : 1. The outermost cells stay empty. */
  private smooth(stride: number): void {
    const { density, smoothed } = this;
    for (let at = LAYER; at < density.length - LAYER; at++)
      smoothed[at] = 0.25 * (density[at - stride] + density[at + stride]) + 0.5 * density[at];
    this.density = smoothed;
    this.smoothed = density;
  }

  private write(faint: number): void {
    const { density } = this;
    const data = this.texture.image.data as Uint8Array;
    for (let at = LAYER; at < density.length - LAYER; at++) {
      const x = density[at - 1] - density[at + 1];
      const y = density[at - ROW] - density[at + ROW];
      const z = density[at - LAYER] - density[at + LAYER];
      const length = (0.5 * SLOPE * Math.sqrt(x * x + y * y + z * z)) / (density[at] + faint);
      const factor = (STEPS * 0.5 * SLOPE) / ((density[at] + faint) * Math.max(1, length));
      data[4 * at] = STEPS + 1.5 + factor * x;
      data[4 * at + 1] = STEPS + 1.5 + factor * y;
      data[4 * at + 2] = STEPS + 1.5 + factor * z;
    }
  }
}

function spline(distance: number): number {
  const away = Math.abs(distance);
  return away < 0.5 ? 0.75 - away * away : away < 1.5 ? 0.5 * (1.5 - away) * (1.5 - away) : 0;
}
